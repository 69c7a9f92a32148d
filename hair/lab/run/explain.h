// Which parts a run of a scene has: what a scene does not need is not there.
#pragma once

#include <string>
#include <vector>

#include "hair/scene/scene.h"

namespace hair {

struct Part {
  std::string name;  // "bending"
  bool used = false;
  std::string why;  // what it is, or why it is left out
};

// All parts that there are, in the same order for each scene; `render` as in RunSettings.
std::vector<Part> explain(const Scene& scene, bool render);

// A line for each: "bending             used      H2: angular springs, ..."
std::string explanation(const std::vector<Part>& parts);

}  // namespace hair
