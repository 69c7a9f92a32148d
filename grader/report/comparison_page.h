// STAFF ONLY. A page for TAs: pictures compared, worst first. What it shows is in it; what it links to, in
// full size, stands beside it.
#pragma once

#include <string>
#include <vector>

#include "grader/compare/comparison.h"

namespace grader {

// A pair in small, as PNG files' bytes.
struct SmallPair {
  ComparedPair pair;
  std::string reference, test, heat;
};

// The files that hold a pair in full size, beside the page: "frame-0003-heat.png".
std::string heat_file(const std::string& name);
std::string side_file(const std::string& name);

std::string comparison_page(const Comparison& comparison, const std::vector<SmallPair>& worst);

}  // namespace grader
