// STAFF ONLY. From what students hand in to the exercise files in it. Nothing is unpacked to disk: an archive is read once, and only
// files that an exercise names are kept, so that paths and links in it can do nothing.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "grader/course/course.h"

namespace grader {

struct SourceFile {
  std::string text;     // the file's bytes
  std::string problem;  // not empty: why it can't be taken, a sentence for the student
};

struct Submission {
  std::string name;                         // of the archive or folder, without its ending
  std::map<std::string, SourceFile> files;  // by exercise file ("conj_grad.cpp"); those that were handed in
  std::string problem;                      // not empty: why nothing in it can be taken, a sentence for the student
};

// The most that is read of one submission.
struct IntakeLimits {
  std::size_t file_bytes = std::size_t{1} << 20;       // one exercise file
  std::size_t unpacked_bytes = std::size_t{256} << 20;  // all that an archive unpacks to
  std::size_t entries = 20000;                         // files and folders
};

// Each argument is a submission (.zip, .tar.gz, .tgz or a folder that holds an exercise file at some depth), a folder of
// submissions, or an archive that holds them. `__MACOSX` and names that begin with a dot are ignored. Sorted by name. Throws BadInput for an argument that
// is neither, and for two submissions with the same name (the message names both).
// What is wrong with one submission is said in it and stops nothing.
std::vector<Submission> read_submissions(const std::vector<std::filesystem::path>& arguments, const Course& course,
                                         const IntakeLimits& limits = {});

}  // namespace grader
