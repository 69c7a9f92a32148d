// The messages of a run, in their order, for any number of readers. Each reader gets all of them from the
// run's start; when a new run begins, readers continue with that one. Of a long run the log keeps the first
// messages, which describe it, and the newest ones.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace hair {

inline constexpr std::size_t kFirstKept = 2, kNewestKept = 1000;

class MessageLog {
 public:
  using Message = std::shared_ptr<const std::string>;

  // A reader's position.
  struct Place {
    long run = 0;
    std::size_t next = 0;
  };

  void begin(std::string first);
  void add(std::string message);
  void close();  // readers stop waiting
  bool closed() const;

  // The next message; null if there is none within the time, or if the log is closed.
  Message next(Place& place, std::chrono::milliseconds wait) const;

 private:
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::deque<Message> messages_;
  std::size_t gone_ = 0;  // messages after the first ones that are not kept
  long run_ = 0;
  bool closed_ = false;
};

}  // namespace hair
