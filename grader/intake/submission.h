// STAFF ONLY. Finds the exercise files in what students hand in. Nothing is unpacked to disk: archives are
// read in memory, and only files with an exercise's name are kept, so that paths and links can do no harm.
//
// A submission is a .zip, a .tar.gz, .tgz or .tar, or a folder. An argument is one submission or holds a
// class of them, as layout.h decides. Archives are recognised by content, not by extension.
//
//   class.zip with alice.zip, bob.tar.gz, carol/   a class of three
//   class/ with alice/, bob/                       a class of two
//   class.zip with Alice_1/handin.zip, Bob_2/...   a class, as some learning platforms export it
//   alice.zip with project/student/conj_grad.cpp   one submission with a whole project
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "grader/course/course.h"

namespace grader {

struct SourceFile {
  std::string text;     // the file's bytes
  std::string problem;  // not empty: why it is rejected, a sentence for the student; then `text` is empty
};

struct Submission {
  // The name of the archive or folder without its extension. Bytes other than letters, digits, '.', '_' and
  // '-' become '_', and so does a leading dot. A name that the class reports need ("staff") gets a '_' at its
  // end.
  std::string name;
  std::map<std::string, SourceFile> files;  // by exercise file ("conj_grad.cpp"); only handed-in files
  std::string problem;  // not empty: why the whole submission is rejected, for the student
};

// Limits for reading one submission. A whole argument may have 50 times the entries, and its stream may
// unpack to 20 times its own size if that is more; honest files compress less than that.
struct IntakeLimits {
  std::size_t file_bytes = std::size_t{1} << 20;  // one exercise file
  std::size_t unpacked_bytes = std::size_t{256}
                               << 20;  // all contents, including nested archives and their contents
  std::size_t entries = 20000;         // files and folders, including those in nested archives
};

// Sorted by name. Files of absent exercises are ignored. An error in one submission is reported in it and
// does not affect others: an archive always gives a submission. Throws BadInput for an argument that does not
// exist, or that is neither an archive nor a folder with an exercise file or an archive in it, and for two
// submissions with the same name (the message names both).
std::vector<Submission> read_submissions(const std::vector<std::filesystem::path>& arguments,
                                         const Course& course, const IntakeLimits& limits = {});

}  // namespace grader
