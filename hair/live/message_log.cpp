#include "hair/live/message_log.h"

#include <algorithm>

namespace hair {

void MessageLog::begin(std::string first) {
  const std::lock_guard lock(mutex_);
  messages_ = {std::make_shared<const std::string>(std::move(first))};
  gone_ = 0;
  ++run_;
  changed_.notify_all();
}

void MessageLog::add(std::string message) {
  const std::lock_guard lock(mutex_);
  messages_.push_back(std::make_shared<const std::string>(std::move(message)));
  if (messages_.size() > kFirstKept + kNewestKept) {
    messages_.erase(messages_.begin() + kFirstKept);
    ++gone_;
  }
  changed_.notify_all();
}

void MessageLog::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

bool MessageLog::closed() const {
  const std::lock_guard lock(mutex_);
  return closed_;
}

MessageLog::Message MessageLog::next(Place& place, std::chrono::milliseconds wait) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, wait,
                    [&] { return closed_ || place.run != run_ || place.next < gone_ + messages_.size(); });
  if (closed_) return {};
  if (place.run != run_) place = {run_, 0};
  if (place.next >= kFirstKept) place.next = std::max(place.next, gone_ + kFirstKept);
  if (place.next >= gone_ + messages_.size()) return {};
  const std::size_t index = place.next < kFirstKept ? place.next : place.next - gone_;
  ++place.next;
  return messages_[index];
}

}  // namespace hair
