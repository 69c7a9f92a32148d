#include "hair/live/message_log.h"

namespace hair {

void MessageLog::begin(std::string first) {
  const std::lock_guard lock(mutex_);
  messages_ = {std::make_shared<const std::string>(std::move(first))};
  ++run_;
  changed_.notify_all();
}

void MessageLog::add(std::string message) {
  const std::lock_guard lock(mutex_);
  messages_.push_back(std::make_shared<const std::string>(std::move(message)));
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
                    [&] { return closed_ || place.run != run_ || place.next < messages_.size(); });
  if (closed_) return {};
  if (place.run != run_) place = {run_, 0};
  return place.next < messages_.size() ? messages_[place.next++] : Message();
}

}  // namespace hair
