// STAFF ONLY. Decides whether an argument holds one submission or a class of them. Only the names in it
// decide, so that the contents of files can't change the owner.
//
// Items are the exercise files and the archives. `__MACOSX`, names that begin with a dot, and everything
// below them are ignored. The root is the deepest folder that contains all items, so that enclosing folders
// make no difference. An argument is
//   1. one submission, if an exercise file lies directly in the root, or a CMakeLists.txt lies in the root or
//      in a folder around it: this is a student's project;
//   2. a class, if two or more of the root's folders and archives are or contain items. Then each folder and
//      each archive in the root is a submission, even without an exercise file, so that nobody is left out;
//   3. a class of one, if it is a folder on disk and one archive lies directly in it: the archive's name then
//      stays the same when others are added;
//   4. otherwise one submission.
// A submission is never a class: everything nested in it belongs to it. Its exercise files may lie at any
// depth; archives in it are opened only if there are no exercise files.
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
  std::vector<std::size_t> entries;  // indices of all counted entries in it, or of the archive only
};

struct Layout {
  std::vector<Member> members;  // by path
  bool is_class = false;        // false: one member, the container
  bool found = false;           // false: neither an exercise file nor an archive in it
};

bool is_ignored(std::string_view path);

Layout layout_of(const std::vector<Entry>& entries, const FileNames& exercise_files, bool on_disk);

// The entries to take from a submission: its exercise files; if there are none, the archives in it.
struct Takings {
  std::vector<std::size_t> files, archives;
};
Takings takings_of(const std::vector<Entry>& list, const std::vector<std::size_t>& entries,
                   const FileNames& exercise_files);

}  // namespace grader
