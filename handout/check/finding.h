// The result of one check, and where the check stands.
#pragma once

#include <string>
#include <vector>

namespace checks {

struct Finding {
  enum class State { passed, failed, broke_off, waits };

  std::string suite, name;  // "Forces", "AreBalanced"
  std::string file;         // "check.cpp"
  int line = 0;             // of its TEST
  State state = State::waits;
  std::vector<std::string> failures;  // GoogleTest's messages; of one that broke off how it ended
  std::string hint;                   // of its numbers, if they show one
  std::string row;                    // of its category's rows, if it names one
  std::string waits_for;              // a function whose checks have to pass before; empty if none has to

  std::string full_name() const { return suite + "." + name; }
};

}  // namespace checks
