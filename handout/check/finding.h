// The result of one check, and where the check stands.
#pragma once

#include <string>
#include <vector>

namespace checks {

struct Finding {
  enum class State { passed, failed, broke_off, waits };

  std::string suite, name;  // "Forces", "AreBalanced"
  std::string file;         // "check.cpp"
  int line = 0;             // its TEST stands here
  State state = State::waits;
  std::vector<std::string> failures;  // GoogleTest's messages, or how the check broke off
  std::string hint;                   // a likely mistake, if the wrong numbers show one
  std::string row;                    // the id of its category's row, if it names one
  std::string waits_for;              // the function whose checks must pass first, if any

  std::string full_name() const { return suite + "." + name; }
};

}  // namespace checks
