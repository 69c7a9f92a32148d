// STAFF ONLY. A page for TAs with compared pictures, worst first. The page contains small pictures and links
// to full-size files beside it.
#pragma once

#include <string>
#include <vector>

#include "grader/compare/comparison.h"

namespace grader::inline report {

// Holds a pair, as the bytes of PNG files. The heat map may be smaller.
struct ShownPair {
  ComparedPair pair;
  std::string reference, test, heat;
};

// Return the names of a pair's full-size files beside the page: "frame-0003-heat.png".
std::string heat_file(const std::string& name);
std::string side_file(const std::string& name);

std::string comparison_page(const Comparison& comparison, const std::vector<ShownPair>& worst);

}  // namespace grader::report
