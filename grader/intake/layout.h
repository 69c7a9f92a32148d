// STAFF ONLY. What an argument holds: one submission or a class of them. The names in it alone decide, so
// that nothing that is written in a file can change whose it is.
//
// Things to look at are the exercise files and the archives. `__MACOSX` and names that begin with a dot don't
// count, nor does anything below them. Let the root be the deepest folder that holds all these things, so
// that any number of folders around them change nothing. Then an argument is
//   1. one submission, if an exercise file lies directly in the root, or a CMakeLists.txt in it or in a
//   folder around
//      it: a student's project, whatever else is in it;
//   2. a class, if two or more of the root's folders and archives are or hold such things. Each folder and
//   each archive
//      in the root is then a submission, those without an exercise file included: nobody who handed in is
//      left out;
//   3. a class of one, if it is a folder on disk and directly in it lies one archive: its name stays when
//   others arrive;
//   4. else one submission.
// A submission is never a class: what is nested in it belongs to it. Its exercise files are those that lie in
// it at any depth; archives in it are opened only if there are none.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "grader/intake/container.h"

namespace grader {

using FileNames = std::set<std::string, std::less<>>;

struct Member {
  std::string path;  // below the container; "" if the container is the submission
  bool archive = false;
  std::vector<std::size_t> entries;  // indices of all that lies in it and counts, or of the archive alone
};

struct Layout {
  std::vector<Member> members;  // by path
  bool is_class = false;        // false: one member, the container
  bool found = false;           // false: neither an exercise file nor an archive in it
};

bool is_ignored(std::string_view path);

Layout layout_of(const std::vector<Entry>& entries, const FileNames& exercise_files, bool on_disk);

// Which of a submission's `entries` to take: its exercise files; if it has none, the archives in it.
struct Takings {
  std::vector<std::size_t> files, archives;
};
Takings takings_of(const std::vector<Entry>& list, const std::vector<std::size_t>& entries,
                   const FileNames& exercise_files);

}  // namespace grader
