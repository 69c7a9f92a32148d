// STAFF ONLY. Mutants that are right programs nevertheless, in reference/<ID>/equivalents.json: the line, its
// change, as in mutation.h, and why it does not matter. If a line has the changed words more than once,
// `occurrence` counts them from 1, the default. A program that goes beyond an array is `undefined`: it may be
// found or not.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/mutants/mutation.h"

namespace grader::inline mutants {

struct Equivalent {
  std::string line, change, why;
  int occurrence = 1;
  bool undefined = false;

  bool is(const std::string& source, const Mutation& mutation) const;
};

// Returns those of an exercise, from the project's folder; none if it has no such file.
std::vector<Equivalent> equivalents_of(const std::string& exercise, const std::filesystem::path& project);

}  // namespace grader::mutants
