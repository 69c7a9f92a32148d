// Starts another program, and waits for its end or for an event.
#pragma once

#include <sys/types.h>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace hair {

// One of a program's three streams: inherited from this program (the default), a descriptor of ours, or a
// file, which is read or written anew.
using Stream = std::variant<std::monostate, int, std::filesystem::path>;

struct Program {
  std::vector<std::string> words;  // its path, then its arguments
  Stream input = {}, output = {}, errors = {};
  std::filesystem::path folder = {};  // its working directory; empty: ours
  std::vector<std::string> environment =
      {};                    // "NAME=value", in addition to ours and instead of one of that name
  bool leads_group = false;  // it is the first of a new process group
};

// Returns its process id. Throws std::system_error, with the program's path, if it can't be started.
pid_t start_program(const Program& program);

// Waits until something has happened. Returns false if the program ended before (exit_code_of tells how).
bool wait_until(const std::function<bool()>& happened, pid_t process);

// Waits until it has ended. Returns its exit code, or nothing if a signal ended it.
std::optional<int> exit_code_of(pid_t process);

// The program's file. Reading it gives the bytes that are running, even if a newer file has replaced its
// name.
std::filesystem::path this_program();

}  // namespace hair
