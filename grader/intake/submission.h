// STAFF ONLY. From what students hand in to the exercise files in it. Nothing is unpacked to disk: archives
// are read in memory, and only files that an exercise names are kept, so that paths and links in them can do
// nothing.
//
// A submission is a .zip, a .tar.gz, .tgz or .tar, or a folder. An argument is a submission or holds a class
// of them; layout.h says which. Archives are told apart by what is in them, not by their ending.
//
//   class.zip with alice.zip, bob.tar.gz, carol/   a class of three
//   class/ with alice/, bob/                       a class of two
//   class.zip with Alice_1/handin.zip, Bob_2/...   a class, as some learning platforms export it
//   alice.zip with project/student/conj_grad.cpp   one submission, whatever else is in the project
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "grader/course/course.h"

namespace grader {

struct SourceFile {
  std::string text;     // the file's bytes
  std::string problem;  // not empty: why it can't be taken, a sentence for the student; then there is no text
};

struct Submission {
  // Of the archive or folder, without its ending. Only letters, digits, '.', '_' and '-' stay, other bytes
  // become '_', so does a dot in front. A name that a report of the class needs ("staff") gets a '_' at its
  // end.
  std::string name;
  std::map<std::string, SourceFile> files;  // by exercise file ("conj_grad.cpp"); those that were handed in
  std::string problem;  // not empty: why nothing in it can be taken, a sentence for the student
};

// The most that is read of one submission. A whole argument may hold 50 times the entries, and its stream may
// unpack to 20 times its own size if that is more: honest files shrink less than that.
struct IntakeLimits {
  std::size_t file_bytes = std::size_t{1} << 20;  // one exercise file
  std::size_t unpacked_bytes = std::size_t{256}
                               << 20;  // all that is in it, archives in it and what they unpack to
  std::size_t entries = 20000;         // files and folders, also of archives in it
};

// Sorted by name. Files of absent exercises are not taken. What is wrong with one submission is said in it
// and stops nothing: an archive always gives a submission. Throws BadInput for an argument that is not there
// or is neither an archive nor a folder with an exercise file or an archive in it, and for two submissions
// with the same name (the message names both).
std::vector<Submission> read_submissions(const std::vector<std::filesystem::path>& arguments,
                                         const Course& course, const IntakeLimits& limits = {});

}  // namespace grader
