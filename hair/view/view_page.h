// The page that plays motions (motion.h): one file, which opens from disk, without a network. Its scripts are
// in page/, and come along.
#pragma once

#include <string>
#include <vector>

namespace hair {

struct NamedMotion {
  std::string name;  // "swing", as readers tell it from the other one
  std::string json;  // motion.json
};

// One motion, or two to compare.
std::string view_page(const std::vector<NamedMotion>& motions);

}  // namespace hair
