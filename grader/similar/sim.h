// STAFF ONLY. Finds runs of equal tokens in C++ sources with sim, Debian's similarity-tester. To sim all
// names are equal, and so are all numbers and all texts; layout and comments don't count. It reads strangers'
// texts, so it runs in a sandbox.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "grader/course/isolation.h"
#include "grader/sandbox/processes/identity.h"
#include "grader/sandbox/sandbox.h"

namespace grader::inline similar {

struct Lines {
  int first = 0, last = 0;  // from 1 on, both included
};

// This is a run of tokens of one text that another one has, too. A text's runs in one other text don't
// overlap.
struct Match {
  std::size_t text = 0, other = 0;
  Lines lines, other_lines;
  int tokens = 0;
};

struct Matches {
  std::vector<int> tokens;  // has one for each text; -1: sim could not read it
  std::vector<Match> all;   // between two texts in both directions
};

class Sim {
 public:
  explicit Sim(Isolation isolation);  // throws BadInput if sim is not installed

  // Compares each text with each other one, or, if there are `given` texts, with each of those alone: then
  // Match::other counts these. A run has `least` tokens at least. Throws std::runtime_error if sim does not
  // end in these seconds of CPU time.
  Matches matches(const std::vector<std::string>& texts, const std::vector<std::string>& given, int least,
                  int cpu_seconds = 600) const;

 private:
  std::string output_of(const std::vector<std::string>& options, std::size_t texts, std::size_t given,
                        int cpu_seconds, bool& well) const;

  StagingFolder folder_;
  Sandbox sandbox_;
};

}  // namespace grader::similar
