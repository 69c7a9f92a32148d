// STAFF ONLY. Decides if an argument without a learning system's names is one submission or a class of them.
// Only the names in it decide, so that the contents of files can't change the owner.
//
// Items are the exercise files, also under names that copies get (exercise_names.h), and the archives.
// Names of operating systems (names.h), and everything below them, are ignored. The root is the deepest
// folder that contains all items, so that enclosing folders make no difference.
//
// The first of these rules that holds decides:
// 1. A student's project is one submission: the root, or a folder around it, has a CMakeLists.txt and beside
// it a folder of the handout (solver, particles, hair or student).
// 2. Two or more folders and archives in the root make a class, if each of them is or contains an item.
// Folders that are copies by their names ("hw", "hw - Copy", "hw (1)") are one student's. Folders of builds
// ("build", "cmake-build-debug") are nobody's.
// 3. A folder on disk whose only item is one archive directly in it is a class of one: the archive's name
// stays the same when others are added.
// 4. Everything else is one submission.
//
// In a class each folder, each archive and each document (.pdf) in the root is a submission, even without an
// exercise file, so that nobody is left out. Any other file, also outside of the root, is a stray: it belongs
// to nobody, and is reported. So a bare conj_grad.cpp among the archives of a class changes nothing.
//
// Rule 2 takes one student's conj_grad.cpp with two folders of old copies for a class with a stray file: a
// class of two folders looks the same. In an archive of its own in a folder it is one submission.
//
// A submission is never a class: everything nested in it belongs to it. Its exercise files may lie at any
// depth; archives in it are opened only if there are no exercise files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "grader/intake/archives/container.h"
#include "grader/intake/names/exercise_names.h"

namespace grader::inline intake {

struct Member {
  enum class Kind { whole, folder, archive, document };

  std::string path;  // is below the container; "" if the container is the submission
  Kind kind = Kind::whole;
  // These are the indices of all counted entries in it; an archive or a document has only itself.
  std::vector<std::size_t> entries = {};
};

struct Layout {
  std::vector<Member> members;      // by path
  std::vector<std::string> strays;  // are the paths of files without a member of the class
  bool is_class = false;            // false: one member, the container
  bool found = false;               // false: it holds no item
};

Layout layout_of(const std::vector<Entry>& entries, const FileNames& exercise_files, bool on_disk);

}  // namespace grader::intake
