// STAFF ONLY. The gates that a handout must pass before anyone gets it. Each looks at what is in the archive,
// and throws HandoutError with one line: what leaks or lacks, and where.
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

// The handout holds the files that the manifest lists, all of them and no others.
void check_listing(const Files& handout, const Paths& listed);

// No file holds the words that every file of the staff's begins with. `solved` are the files of given
// exercises, which do.
void check_canary(const Files& handout, const Paths& solved);

// No four consecutive lines of the reference appear in a file, but in `solved`: blank lines, #include and the
// space around a line do not count, nor do four lines that the stub of the same name has, too. `reference`
// and `stubs` are by name ("conj_grad.cpp").
void check_reference_lines(const Files& handout, const Files& reference, const Files& stubs,
                           const Paths& solved);

// Whether a file of the staff's says so, in its first lines.
bool carries_canary(const std::string& text);

}  // namespace grader
