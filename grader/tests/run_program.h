// STAFF ONLY. Runs hairgrade as a user does.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace grader {

struct ProgramRun {
  int code = 0;  // its exit code; -1: a signal ended it
  std::string output, errors;
};

// This is a running hairgrade: its process id, which is also that of its process group.
struct RunningProgram {
  int process;

  // Waits until `happened` returns true. Returns false if the program ended before.
  bool wait_until(const std::function<bool()>& happened) const;
};

// Runs hairgrade with these arguments, and calls `meanwhile` once it runs. If there is a `script`, a shell
// runs it first.
ProgramRun run_hairgrade(const std::vector<std::string>& arguments,
                         const std::function<void(const RunningProgram&)>& meanwhile = {},
                         const std::string& script = "");

// A course file where all exercises but these are given.
nlohmann::json course_of(const std::vector<std::string>& ids);

// The bytes of all files below a folder, by path, but for the record's own.
std::map<std::string, std::string> files_in(const std::filesystem::path& folder);

// Returns the path of a sample of the sample class, in its form there.
std::string sample(const std::string& name);

// Searches `places`, and folders that everybody may write to, for files that samples leave outside of the
// sandbox; their names show it.
std::vector<std::filesystem::path> traces(std::vector<std::filesystem::path> places);

// Calls body(0), ..., body(count - 1), as many at a time as there are processors.
void side_by_side(std::size_t count, const std::function<void(std::size_t)>& body);

// Returns a variable of the environment, or `otherwise`.
std::string environment(const char* name, const std::string& otherwise);

}  // namespace grader
