// Runs checks in a process of their own, so that a check that breaks off or never ends leaves the others
// alone.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace checks {

// The result of one check, and where the check stands.
struct Finding {
  enum class State { passed, failed, broke_off, waits };

  std::string suite, name;  // "Forces", "AreBalanced"
  std::string file;         // "check.cpp"
  int line = 0;             // its TEST stands here
  State state = State::waits;
  std::vector<std::string> failures;  // GoogleTest's messages, or how the check broke off
  std::string hint;                   // a likely mistake, if the wrong numbers show one
  std::string waits_for;              // the function whose checks must pass first, if any

  std::string full_name() const { return suite + "." + name; }
};

// CPU seconds that a check may take before its process is ended. Right programs take one or two for all
// checks together.
inline constexpr unsigned kMostSeconds = 20;

// Runs the findings' checks, all of one suite, in their order, and fills in states and failures. After two
// checks that never ended the others are left waiting. The standard output stays this program's.
void run_apart(std::vector<Finding*> checks, unsigned seconds = kMostSeconds);

// Makes a call in a process of its own, and returns the sentence of the NotImplemented that it throws; "" if
// it throws none.
std::string not_implemented_by(const std::function<void()>& call, unsigned seconds = kMostSeconds);

// A sentence about a process that ended in the middle of a check, from its signal (0: none) and its text on
// the standard error. A sanitizer's report becomes its first line, and the line of your file.
std::string how_it_ended(int signal, const std::string& written);

}  // namespace checks
