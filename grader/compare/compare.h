// STAFF ONLY. The distance between two pictures, as numbers; the comparison of many.
//
// If a thin strand moves by one pixel, all of its pixels are wrong, but it looks the same. The blurred RMSE
// ignores such shifts. FLIP measures the difference that a person sees who flips between the two pictures,
// including a moved strand.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/compare/flip.h"

namespace grader::inline compare {

inline constexpr double kBlur = 4;  // px, sigma of the Gaussian

// Limit the distances of a right run's pictures.
inline constexpr double kBlurredRmse = 0.0005, kFlip = 0.001;

struct PictureDistance {
  // This is the root mean square, over pixels and channels, of the difference of the pictures blurred by
  // kBlur: from 0 to 1, which is black against white. It uses the encoded values, 0 to 1: equal steps of them
  // look about equally large, so that hair in the shadow counts as much as hair in the light.
  double blurred_rmse = 0;
  double flip_mean = 0, flip_max = 0;
  bool identical = false;  // byte for byte
};

// Both pictures must have the same size, else throws std::invalid_argument. The distance is symmetric.
PictureDistance compare_pictures(const hair::Image& reference, const hair::Image& test);

// Does the same, with a FLIP map that was already computed.
PictureDistance compare_pictures(const hair::Image& reference, const hair::Image& test, const ErrorMap& map);

struct ComparedPair {
  std::string name;
  int width = 0, height = 0;
  PictureDistance distance;
  std::string obstacle = {};  // says why it could not be compared; the numbers then mean nothing
};

struct Comparison {
  std::string reference, test;      // as given on the command line
  std::vector<ComparedPair> pairs;  // worst first
  std::vector<std::string> only_in_reference, only_in_test;
};

// True if every picture of both folders was compared.
bool is_complete(const Comparison& comparison);

// A pair that could not be compared is worse than all others. FLIP's mean, maximum, and the name follow.
bool is_worse(const ComparedPair& a, const ComparedPair& b);

std::size_t count_identical(const Comparison& comparison);
std::size_t count_compared(const Comparison& comparison);

// This is for a terminal: ASCII, worst first, so that missing pictures come first. Identical pairs are
// counted, not listed.
std::string comparison_table(const Comparison& comparison);

// {"pairs": [{"name", "width", "height", "identical", "blurred_rmse", "flip_mean", "flip_max"}], worst first,
// "only_in_first": [names], "only_in_second": [names]}. A pair that could not be compared has "name" and
// "not_compared", the reason.
std::string comparison_json(const Comparison& comparison);

// ---- The pairs of pictures to compare, from the command line's arguments ----

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
