// STAFF ONLY. Mutants that are right programs nevertheless, in reference/<ID>/equivalents.json: the line and
// what is changed in it, as in mutation.h, and why it does not matter. `occurrence` says which, where a line
// has what is changed more than once: from 1, which is what it is without the key.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/mutants/mutation.h"

namespace grader::inline mutants {

struct Equivalent {
  std::string line, change, why;
  int occurrence = 1;

  bool is(const std::string& source, const Mutation& mutation) const;
};

// Those of an exercise, from the project's folder; none where it has no such file.
std::vector<Equivalent> equivalents_of(const std::string& exercise, const std::filesystem::path& project);

}  // namespace grader::mutants
