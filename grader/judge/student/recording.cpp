// STAFF ONLY. Keeps requests and products of each category.
#include "grader/judge/student/recording.h"

namespace grader::inline judge {

void Recording::begin_category(const std::string& name) {
  category_ = name;
  bytes_ = 0;
}

void Recording::begin_case() {
  if (keeps_ == Keeps::all_cases) return;
  requests_.clear();
  bytes_ = 0;
  cut_ = false;
}

bool Recording::has_room_for(std::size_t bytes, std::size_t most) {
  const bool has_room = bytes <= most;
  cut_ |= !has_room;
  return has_room;
}

void Recording::begin(const MessageWriter& message) {
  product_bytes_ = 0;
  open_ = has_room_for(bytes_ + message.bytes().size(), kMostBytes);
  if (!open_) return;
  bytes_ += message.bytes().size();
  requests_.push_back({category_, message, {}, Outcome::crashed});
}

void Recording::add_product(int which, const std::vector<double>& question, const std::vector<double>& result,
                            bool go_on) {
  const bool with_question = keeps_ == Keeps::last_case;
  const std::size_t bytes = (result.size() + (with_question ? question.size() : 0)) * sizeof(double);
  const std::size_t most = with_question ? kMostBytes : kMostProductBytes;
  if (!open_ || !has_room_for(product_bytes_ + bytes, most)) return;
  product_bytes_ += bytes;
  bytes_ += bytes;
  requests_.back().products.push_back(
      {which, result, go_on, with_question ? question : std::vector<double>()});
}

void Recording::end(Outcome outcome, const MessageReader& reply) {
  if (open_) requests_.back().outcome = outcome;
  if (open_ && keeps_ == Keeps::last_case && outcome == Outcome::done) requests_.back().reply = reply;
  open_ = false;
}

Recording::GivenCall* Recording::begin_call(const MessageReader& call) {
  if (!open_ || keeps_ == Keeps::all_cases) return nullptr;
  requests_.back().calls.push_back({call});
  return &requests_.back().calls.back();
}

}  // namespace grader::judge
