// STAFF ONLY. Keeps requests and products.
#include "grader/judge/student/recording.h"

namespace grader::inline judge {

void Recording::begin_case() {
  if (keeps_ == Keeps::all_cases) return;
  requests_.clear();
  bytes_ = 0;
  cut_ = false;
}

bool Recording::has_room_for(std::size_t bytes) {
  const bool has_room = bytes_ + bytes <= kMostBytes;
  if (has_room) bytes_ += bytes;
  cut_ |= !has_room;
  return has_room;
}

void Recording::begin(const MessageWriter& message) {
  open_ = has_room_for(message.bytes().size());
  if (open_) requests_.push_back({message});
}

void Recording::add_product(int which, const std::vector<double>& question, const std::vector<double>& result,
                            bool go_on) {
  const bool with_question = keeps_ == Keeps::last_case;
  const std::size_t numbers = result.size() + (with_question ? question.size() : 0);
  if (!open_ || !has_room_for(numbers * sizeof(double))) return;
  requests_.back().products.push_back(
      {which, result, go_on, with_question ? question : std::vector<double>()});
}

void Recording::end(Outcome outcome, const MessageReader& reply) {
  if (open_ && keeps_ == Keeps::last_case && outcome == Outcome::done) requests_.back().reply = reply;
  open_ = false;
}

Recording::GivenCall* Recording::begin_call(const MessageReader& call) {
  if (!open_ || keeps_ == Keeps::all_cases) return nullptr;
  requests_.back().calls.push_back({call});
  return &requests_.back().calls.back();
}

}  // namespace grader::judge
