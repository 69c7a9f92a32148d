// STAFF ONLY. Checks ("gates") that a handout must pass before its release. Each checks the archive's
// contents and throws HandoutError with one line: what leaks or is missing, and where.
#pragma once

#include <map>
#include <set>
#include <stdexcept>
#include <string>

namespace grader {

class HandoutError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

using Files = std::map<std::string, std::string>;  // path -> bytes
using Paths = std::set<std::string>;

// The handout contains exactly the files that the manifest lists.
void check_listing(const Files& handout, const Paths& listed);

// No file contains the mark with which every staff file begins. `solved` are the files of given exercises,
// which contain it.
void check_canary(const Files& handout, const Paths& solved);

// No file except `solved`, stubs no more than others, says what four consecutive lines of the reference say; of these at least
// three have letters, at least 30 in all. Only letters, digits and underscores count: other ends of lines, blanks and marks of
// comments hide nothing. Blank lines, #include, using and namespace are left out. The keys of `reference` are file names
// ("conj_grad.cpp").
void check_reference_lines(const Files& handout, const Files& reference, const Paths& solved);

// Whether a text has the staff's mark in its first lines.
bool carries_canary(const std::string& text);

}  // namespace grader
