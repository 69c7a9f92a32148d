// The process that runs a scene (runner.h), as its parent sees it. It may crash, or hang.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "hair/live/commands_in.h"

namespace hair {

class Child {
 public:
  // words: its program, then its arguments. Throws std::system_error if it can't be started.
  Child(const std::vector<std::string>& words, const std::string& settings);
  ~Child();  // ends it
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  void tell(const std::string& command);  // has no effect on a process that has ended

  // The next message; nothing if there is none within the time.
  std::optional<std::string> next(int milliseconds);

  // A sentence about its end, once it has ended; empty if its trouble is reported already.
  std::optional<std::string> ended();

  // The caller itself was stopped meanwhile, so the silence before does not count.
  void forgive_silence() { heard_ = std::chrono::steady_clock::now(); }

  // Ends it if it was silent for `longest`, and for ten times its longest silence so far, because its steps
  // may take long. Before its first message it has three times `longest`. Returns a sentence about that,
  // once.
  std::optional<std::string> stop_if_silent(std::chrono::seconds longest);

 private:
  void read_whereabouts(const std::string& line);
  std::string after() const;  // " in H6 (hair::correct) after step 17"

  int to_ = -1, from_ = -1;
  std::optional<CommandsIn> messages_;
  pid_t process_ = -1;  // -1: it has ended
  long steps_ = 0;
  std::string where_;  // " in H6 (hair::correct)"
  bool has_begun_ = false, has_trouble_ = false, stopped_ = false;
  std::chrono::steady_clock::time_point heard_;
  std::chrono::steady_clock::duration slowest_{};  // the longest time between two messages
};

}  // namespace hair
