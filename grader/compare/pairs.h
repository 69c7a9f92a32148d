// STAFF ONLY. Which pictures are compared with which: what a person names on the command line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace grader {

struct PicturePair {
  std::string name;  // the file's, the second's if they differ
  std::filesystem::path reference, test;
};

struct PicturePairs {
  std::vector<PicturePair> pairs;  // sorted by name
  std::vector<std::string> only_in_reference, only_in_test;
};

// Two files, or the files *.png of two folders, matched by their names. Throws BadInput: nothing there, one
// file and one folder, a folder without pictures, no name that is in both.
PicturePairs find_pairs(const std::filesystem::path& reference, const std::filesystem::path& test);

}  // namespace grader
