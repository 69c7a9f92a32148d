// Lists the parts of a scene's run: a scene uses only the parts that it needs.
#pragma once

#include <string>
#include <vector>

#include "hair/course/course.h"
#include "hair/scene/scene.h"

namespace hair {

struct Part {
  std::string name;                 // "bending"
  bool used = false, stub = false;  // stub: an exercise that the scene calls and that is not written
  std::string why;                  // its effect, or why it is not used
};

// All existing parts, and the course's exercises, in the same order for each scene; `render` as in
// RunSettings.
std::vector<Part> explain(const Scene& scene, bool render, const Course& course);

// One line for each part: "bending    used    H2: angular springs, ..."; "stub" for an unwritten exercise.
std::string explanation(const std::vector<Part>& parts);

}  // namespace hair
