// STAFF ONLY. Which of several files of one name counts in a container, by their paths alone: dates in an
// archive say when it was unpacked, or nothing. A rule decides between two files, or nobody does. The first
// of these that tells them apart:
//
//   1. a file in a folder of builds or backups ("build", "bin", "old hw", "hw.bak", "hw - Copy") counts less than one in no such folder
//   2. a copy by its name ("conj_grad (1).cpp", exercise_names.h) counts less than the file that is built, "conj_grad.cpp"
//   3. a file below a folder "student" counts more: the handout's is called so
//   4. of paths that differ by numbers of versions alone ("Version 2", "v2", "hw (2)"; "conj_grad-2.cpp"), the highest counts
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace grader::inline intake {

// A folder that builds are made in is no person, whatever it holds.
bool is_build(std::string_view folder);

bool lies_in_a_build(std::string_view path);

// True if a folder or an archive on the way to `path` holds builds or backups.
bool is_set_aside(std::string_view path);

struct Candidate {
  std::size_t entry;
  std::string_view path;
  bool renamed = false;  // under a name that copies get
  int number = -1;       // of the copy
};

// Puts those that count most first, and says how many they are: more than one if no rule tells them apart.
std::size_t put_best_first(std::vector<Candidate>& candidates);

}  // namespace grader::intake
