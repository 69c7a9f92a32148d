// STAFF ONLY. The pairs of pictures to compare, from the command line's arguments.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace grader::inline compare {

struct PicturePair {
  std::string name;  // is the file name; the second file's name if they differ
  std::filesystem::path reference, test;
};

struct PicturePairs {
  std::vector<PicturePair> pairs;  // sorted by name
  std::vector<std::string> only_in_reference, only_in_test;
};

// Takes two files, or two folders' entries with the name *.png, in upper or lower case (also entries that are
// no files, which fail when they are read). They are matched by name; names that differ in the case of ".png"
// alone match, too. Throws BadInput if a path does not exist, if one is a file and one a folder, if a folder
// has no pictures, or if no name is in both.
PicturePairs find_pairs(const std::filesystem::path& reference, const std::filesystem::path& test);

}  // namespace grader::compare
