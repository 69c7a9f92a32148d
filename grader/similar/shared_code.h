// STAFF ONLY. Code that hand-ins of one exercise share beyond what everybody was given.
//
// Lines that stand in given texts (stubs, samples) are blanked first: they are no part of what is compared,
// nor of the whole that parts are taken of. A pair's part is the larger one of "this much of mine is in
// yours" and "of yours in mine", so that a copy in a longer text counts in full. It is a hint for a person:
// two who solve the same short task write similar code.
#pragma once

#include <string>
#include <vector>

#include "grader/similar/sim.h"

namespace grader::inline similar {

struct SimilarFile {
  std::string name, text;  // whose, and their file
  std::string shown = {};  // as people read the name; "": as it is
  bool earlier = false;    // of an earlier year: not compared with others of these
};

struct SimilarRules {
  double least_part = 0.6;  // of a pair that is told
  int run_tokens = 24;      // of a run between two hand-ins
  int given_tokens = 12;    // of a run that was given: a loop's head has 13
  int least_tokens = 60;    // shorter files can't be compared: they are alike by chance
  int most_tokens = 20000;  // ten times the longest honest file; two of them take sim a second
  std::size_t many = 5;     // so many people that a piece belongs to many
  int cpu_seconds = 600;  // of a comparison; after a fifth of it, files that repeat themselves are looked for
};

struct SharedBlock {
  Lines lines, other_lines;
  int tokens = 0;
};

// Two hand-ins, by their places in the list. The blocks are those of the one who has the larger part, `one`.
struct SharedPair {
  std::size_t one = 0, other = 0;
  double part = 0;  // of one's own tokens
  int tokens = 0;   // that both have
  int of_many = 0;  // of these, what many have
  std::vector<SharedBlock> blocks;
};

// A piece that many have: where it stands in the file of the first of them, and who they are.
struct CommonPiece {
  Lines lines;
  std::vector<std::size_t> owners;
};

struct NotCompared {
  std::size_t file = 0;
  std::string why;
  bool too_short = false;  // nothing to look at
};

struct SharedCode {
  std::vector<std::string> own;   // the texts without what was given: its lines are empty
  std::vector<SharedPair> pairs;  // the largest parts first
  std::vector<CommonPiece> common;
  std::vector<NotCompared> not_compared;
};

// Groups of three and more who are joined by pairs.
std::vector<std::vector<std::size_t>> groups_of(const SharedCode& shared, std::size_t files);

SharedCode shared_code(const Sim& sim, const std::vector<SimilarFile>& files,
                       const std::vector<std::string>& given, const SimilarRules& rules = {});

}  // namespace grader::similar
