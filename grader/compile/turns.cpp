// STAFF ONLY. Lets a thread wait while another one uses the same key.
#include "grader/compile/turns.h"

#include <utility>

namespace grader::inline compile {

Turns::Turn::Turn(Turns& turns, std::string key) : turns_(turns), key_(std::move(key)) {
  std::unique_lock lock(turns_.mutex_);
  turns_.ended_.wait(lock, [&] { return !turns_.taken_.contains(key_); });
  turns_.taken_.insert(key_);
}

Turns::Turn::~Turn() {
  {
    const std::lock_guard lock(turns_.mutex_);
    turns_.taken_.erase(key_);
  }
  turns_.ended_.notify_all();
}

}  // namespace grader::compile
