// STAFF ONLY. A student's code as the suite sees it: somebody behind two pipes who gets requests and may
// answer. Nothing that comes back is believed; a worker that dies is started again for the next request.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grader/sandbox/cage.h"
#include "grader/suite/watchdog.h"
#include "grader/wire/channel.h"
#include "grader/wire/message.h"

namespace grader {

struct WorkerSetup {
  std::filesystem::path kit;                   // see grader/worker/CMakeLists.txt
  std::string exercise;                        // whose server answers
  std::vector<std::filesystem::path> objects;  // in the order in which they are loaded; the student's last
  std::filesystem::path log;                   // what the worker prints is appended here
  bool isolated = true;
  int cpu_seconds = 10;  // of one worker
  Watchdog::Patience patience = {};
};

enum class Outcome {
  done,
  stopped,  // the suite had seen enough products
  not_implemented,
  threw,
  out_of_memory,
  crashed,
  timed_out,
  broke_rules,
  cannot_load,
};

struct Answer {
  Outcome outcome;
  MessageReader reply;  // of what the server wrote, if done
  std::string note;     // for staff: what happened
};

class Student {
 public:
  static constexpr int kMostRestarts = 5;  // after crashes
  static constexpr int kMostTimeouts = 2;  // the third would only cost more time

  explicit Student(WorkerSetup setup) : setup_(std::move(setup)) {}

  // Serves one product of operator `which`: y = A x, y sized by the handler. False: enough, give up on this
  // request. Throws MalformedMessage for an operator or a length that makes no sense.
  using Products = std::function<bool(int which, const std::vector<double>& x, std::vector<double>& y)>;

  // Sends a request and waits for its answer.
  Answer ask(const MessageWriter& request, const Products& products);

  // Of the workers that `finish` ended; what one used that died by itself is not known.
  double cpu_seconds() const { return cpu_seconds_; }

  // What the worker that there is now has used so far, all its threads together, by the kernel's clock: nothing that
  // runs in it can turn that back. Nothing if there is none.
  std::optional<double> worker_cpu_seconds() const;
  int starts() const { return starts_; }
  const std::optional<Answer>& gave_up() const { return gave_up_; }  // the last answer, for good
  void finish();

 private:
  struct Worker;

  std::optional<Answer> start();
  Answer converse(const MessageWriter& request, const Products& products);
  Answer broke_rules(const MalformedMessage& error);
  Answer ended(const std::string& during);

  WorkerSetup setup_;
  std::shared_ptr<Worker> worker_;
  std::optional<Answer> gave_up_;
  double cpu_seconds_ = 0;
  int starts_ = 0, timeouts_ = 0;
};

}  // namespace grader
