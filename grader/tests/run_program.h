// STAFF ONLY. Runs hairgrade as a user does.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace grader {

struct ProgramRun {
  int code = 0;  // its exit code; -1: a signal ended it
  std::string output, errors;
};

// A hairgrade that runs: the id of its process, which is also that of its process group, and the file that
// its errors go to.
struct RunningProgram {
  int process;
  std::filesystem::path errors;

  // Waits until something has happened. False: the program ended before.
  bool wait_until(const std::function<bool()>& happened) const;
  bool wait_until_it_says(const std::string& words) const;
};

// Runs hairgrade with these arguments, and calls `meanwhile` once it runs. A shell starts it after `script`,
// if there is one.
ProgramRun run_hairgrade(const std::vector<std::string>& arguments,
                         const std::function<void(const RunningProgram&)>& meanwhile = {},
                         const std::string& script = "");

// The path of a sample of the sample class, in whatever form it is there.
std::string sample(const std::string& name);

// A variable of the environment, or what stands for it.
std::string environment(const char* name, const std::string& otherwise);

}  // namespace grader
