// STAFF ONLY. Checks ("gates") that a handout must pass before its release. Each checks the archive's
// contents and throws HandoutError with one line: the leak or the missing file, and its place.
#pragma once

#include <map>
#include <set>
#include <stdexcept>
#include <string>

namespace grader::inline package {

class HandoutError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

using Files = std::map<std::string, std::string>;  // path -> bytes
using Paths = std::set<std::string>;

// Checks that the handout contains exactly the files that the manifest lists.
void check_listing(const Files& handout, const Paths& listed);

// True for *_test.cpp, test_* and tests.cmake, a list of tests: a folder ships without them.
bool is_test_by_name(const std::string& path);

// Checks that a folder that ships holds no tests, benchmarks, fuzz programs or staff files; `where` names its
// line. The keys are the files' paths in the project.
void check_folder(const Files& files, const std::string& where);

// Checks that the whole course ships exactly the files that a person accepted (handout/packed.txt). Names
// each file that is new or gone.
void check_accepted(const Paths& now, const Paths& accepted);

// Checks that no file contains the mark with which every staff file begins. `solved` are the files of given
// exercises, which contain it.
void check_canary(const Files& handout, const Paths& solved);

// Checks that no file except `solved`, stubs included, has the letters of four or more consecutive lines of
// the reference: as many as it takes until three have letters, 30 in all. Digits and underscores count as
// letters. Ends of lines, blanks, marks of comments and escapes hide nothing; comments after // are
// compared and also left out. Blank lines, #include, and the beginnings of using and namespace are left
// out. The keys of `reference` are file names ("conj_grad.cpp").
void check_reference_lines(const Files& handout, const Files& reference, const Paths& solved);

// True if a text has the staff's mark in its first lines.
bool carries_canary(const std::string& text);

}  // namespace grader::package
