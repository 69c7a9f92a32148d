// STAFF ONLY. Chooses one of several files with the same name in a container, by their paths alone: dates may
// be those of unpacking. The first rule that applies to two files decides, or else a person:
// 1. Files among builds or backups ("build", "bin", "old hw", "hw.bak", "hw - Copy") count less than others.
// 2. A copy ("conj_grad (1).cpp", exercise_names.h) counts less than the built file, "conj_grad.cpp".
// 3. A file below a folder "student", as in the handout, counts more.
// 4. If paths differ only by versions ("Version 2", "v2", "hw (2)"; "conj_grad-2.cpp"), the highest counts.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace grader::inline intake {

// A folder of builds never belongs to a person.
bool is_build(std::string_view folder);

bool lies_in_a_build(std::string_view path);

// True if a folder or an archive on the way to `path` holds builds or backups.
bool is_set_aside(std::string_view path);

struct Candidate {
  std::size_t entry;
  std::string_view path;
  bool renamed = false;  // has a name that copies get
  int number = -1;       // is the copy's number
};

// Puts the best ones first, and returns their number: more than one if no rule separates them.
std::size_t put_best_first(std::vector<Candidate>& candidates);

}  // namespace grader::intake
