// STAFF ONLY. Keeps requests and products of each category.
#include "grader/judge/student/recording.h"

namespace grader::inline judge {

void Recording::begin_category(const std::string& name) {
  category_ = name;
  bytes_ = 0;
}

void Recording::begin(const MessageWriter& message) {
  product_bytes_ = 0;
  open_ = bytes_ + message.bytes().size() <= kMostBytes;
  if (!open_) return;
  bytes_ += message.bytes().size();
  requests_.push_back({category_, message, {}, Outcome::crashed});
}

void Recording::add_product(int which, const std::vector<double>& result, bool go_on) {
  const std::size_t bytes = result.size() * sizeof(double);
  if (!open_ || product_bytes_ + bytes > kMostProductBytes) return;
  product_bytes_ += bytes;
  bytes_ += bytes;
  requests_.back().products.push_back({which, result, go_on});
}

void Recording::end(Outcome outcome) {
  if (open_) requests_.back().outcome = outcome;
  open_ = false;
}

}  // namespace grader::judge
