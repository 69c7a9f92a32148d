// STAFF ONLY. Code that hand-ins of one exercise share beyond the given code.
//
// Lines of given texts (stubs, samples) are blanked first: they count neither as shared nor as a part of the
// whole. A pair's part is the larger one of "this much of mine is in yours" and "of yours in mine", so that a
// copy in a longer text counts in full. It is a hint for a person: two who solve the same short task write
// similar code.
#pragma once

#include <string>
#include <vector>

#include "grader/similar/sim.h"

namespace grader::inline similar {

struct SimilarFile {
  std::string name, text;  // are the owner's, and the file's text
  std::string shown = {};  // is the name for people; "": `name`
  bool earlier = false;    // from an earlier year: not compared with others of these
};

struct SimilarRules {
  double least_part = 0.6;  // selects the reported pairs
  int run_tokens = 24;      // is for runs between two hand-ins
  int given_tokens = 12;    // is for given runs: a loop's head has 13
  int least_tokens = 60;    // shorter files can't be compared: they are alike by chance
  int most_tokens = 20000;  // ten times the longest honest file; two of them take sim a second
  std::size_t many = 5;     // a piece of this many people is common
  int cpu_seconds = 600;    // limits a comparison; a fifth of it passes before a search for repetitive files
};

// Names two hand-ins by their places in the list. The blocks are those in `one`, which has the larger part.
struct SharedPair {
  std::size_t one = 0, other = 0;
  double part = 0;  // is a share of the owner's tokens
  int tokens = 0;   // counts common ones
  int of_many = 0;  // counts those in common pieces
  std::vector<Match> blocks;
};

// This is a piece that many have: its place in the file of its first owner, and all owners.
struct CommonPiece {
  Lines lines;
  std::vector<std::size_t> owners;
};

struct NotCompared {
  std::size_t file = 0;
  std::string why;
  bool too_short = false;  // there is nothing to compare
};

struct SharedCode {
  std::vector<std::string> own;   // have empty lines for given ones
  std::vector<SharedPair> pairs;  // the largest parts first
  std::vector<CommonPiece> common;
  std::vector<NotCompared> not_compared;
};

// Returns groups of three and more people who are connected by pairs.
std::vector<std::vector<std::size_t>> groups_of(const SharedCode& shared, std::size_t files);

SharedCode shared_code(const Sim& sim, const std::vector<SimilarFile>& files,
                       const std::vector<std::string>& given, const SimilarRules& rules = {});

}  // namespace grader::similar
