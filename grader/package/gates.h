// STAFF ONLY. Checks ("gates") that a handout must pass before its release. Each checks the archive's
// contents and throws HandoutError with one line: what leaks or is missing, and where.
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

// The handout contains exactly the files that the manifest lists.
void check_listing(const Files& handout, const Paths& listed);

// What ships as a folder holds no tests, benchmarks, fuzz programs or staff files; `where` names its line.
// The keys are the files' paths in the project.
void check_folder(const Files& files, const std::string& where);

// The whole course ships exactly what it shipped when somebody last looked (handout/packed.txt). Says each
// file that is new or gone.
void check_accepted(const Paths& now, const Paths& accepted);

// No file contains the mark with which every staff file begins. `solved` are the files of given exercises,
// which contain it.
void check_canary(const Files& handout, const Paths& solved);

// No file but `solved`, stubs included, has the letters of four or more consecutive lines of the reference:
// as many as it takes until three have letters, 30 in all. Digits and underscores count as letters. Ends of
// lines, blanks, marks of comments and escapes hide nothing, and comments after // are read and left out.
// Blank lines, #include, and the beginnings of using and namespace are left out. The keys of `reference` are
// file names ("conj_grad.cpp").
void check_reference_lines(const Files& handout, const Files& reference, const Paths& solved);

// Whether a text has the staff's mark in its first lines.
bool carries_canary(const std::string& text);

}  // namespace grader::package
