// STAFF ONLY. Runs hairgrade as a user does.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace grader {

struct ProgramRun {
  int code = 0;  // its exit code; -1: a signal ended it
  std::string output, errors;
};

// Runs hairgrade with these arguments. `meanwhile` is called with its process id once it runs, which is also
// the id of its process group.
ProgramRun run_hairgrade(const std::vector<std::string>& arguments,
                         const std::function<void(int)>& meanwhile = {});

// A variable of the environment, or what stands for it.
std::string environment(const char* name, const std::string& otherwise);

}  // namespace grader
