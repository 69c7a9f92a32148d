// STAFF ONLY. The points of the whole run of an exercise's hidden scene.
#pragma once

namespace grader {

// 0 for an exercise that no scene needs.
struct WholeRunPoints {
  double run = 0, pictures = 0;
};

}  // namespace grader
