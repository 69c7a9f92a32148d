// STAFF ONLY. Records requests of the cases to a worker, and the suite's products for them; kMostBytes at
// most, the rest is left out.
//
// A recording of the last case alone also keeps the worker's questions, its replies, and its calls of given
// functions: all that makes the case once more without the suite.
#pragma once

#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "grader/wire/message.h"

namespace grader::inline judge {

// How a request to a student's worker ended.
enum class Outcome {
  done,
  stopped,  // the suite stopped it after enough products
  not_implemented,
  threw,
  out_of_memory,
  crashed,
  timed_out,
  broke_rules,
  cannot_load,
};

class Recording {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{4} << 20;

  enum class Keeps { all_cases, last_case };
  explicit Recording(Keeps keeps = Keeps::all_cases) : keeps_(keeps) {}

  struct Product {
    int which;
    std::vector<double> result;
    bool go_on;
    std::vector<double> question = {};
  };
  struct GivenCall {
    MessageReader call;
    std::vector<std::pair<int, std::vector<double>>> callbacks = {};  // about the worker's own objects
    std::optional<MessageReader> result = {};
  };
  struct Request {
    MessageWriter message;
    std::vector<Product> products = {};
    std::optional<MessageReader> reply = {};
    std::deque<GivenCall> calls = {};
  };

  void begin_case();

  // A request begins, gets a product, and ends. Only Student calls these functions.
  void begin(const MessageWriter& message);
  void add_product(int which, const std::vector<double>& question, const std::vector<double>& result,
                   bool go_on);
  void end(Outcome outcome, const MessageReader& reply);
  // Returns null if it is not kept, and else the place for the call's callbacks and result.
  GivenCall* begin_call(const MessageReader& call);

  const std::vector<Request>& requests() const { return requests_; }
  bool is_cut() const { return cut_; }  // something of the last case was left out

 private:
  bool has_room_for(std::size_t bytes);

  Keeps keeps_;
  std::vector<Request> requests_;
  bool open_ = false, cut_ = false;
  std::size_t bytes_ = 0;
};

}  // namespace grader::judge
