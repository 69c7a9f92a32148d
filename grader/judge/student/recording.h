// STAFF ONLY. Records requests of the cases to a worker, and the suite's products for them, so that another
// worker can get the same. A second worker then costs the suite no cases, and no computing of its own.
//
// A category keeps at most kMostBytes, and the products of one request kMostProductBytes; the rest is not
// repeated. Cases have few sizes, and each of them comes early.
#pragma once

#include <string>
#include <vector>

#include "grader/judge/student/outcome.h"
#include "grader/wire/message.h"

namespace grader::inline judge {

class Recording {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{4} << 20, kMostProductBytes = std::size_t{1} << 20;

  struct Product {
    int which;
    std::vector<double> result;
    bool go_on;
  };
  struct Request {
    std::string category;
    MessageWriter message;
    std::vector<Product> products;
    Outcome outcome = Outcome::crashed;
  };

  void begin_category(const std::string& name);

  // A request begins, gets a product, and ends. Only Student calls these functions.
  void begin(const MessageWriter& message);
  void add_product(int which, const std::vector<double>& result, bool go_on);
  void end(Outcome outcome);

  const std::vector<Request>& requests() const { return requests_; }

 private:
  std::string category_;
  std::vector<Request> requests_;
  bool open_ = false;
  std::size_t bytes_ = 0, product_bytes_ = 0;
};

}  // namespace grader::judge
