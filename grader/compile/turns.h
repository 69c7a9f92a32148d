// STAFF ONLY. Lets one thread at a time use each key: others wait until it has made the file.
#pragma once

#include <condition_variable>
#include <mutex>
#include <set>
#include <string>

namespace grader::inline compile {

class Turns {
 public:
  // Waits until no other turn has this key, and holds it until destruction, before that of `turns`.
  class Turn {
   public:
    Turn(Turns& turns, std::string key);
    ~Turn();
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

   private:
    Turns& turns_;
    std::string key_;
  };

 private:
  std::mutex mutex_;  // guards the keys
  std::condition_variable ended_;
  std::set<std::string> taken_;
};

}  // namespace grader::compile
