// STAFF ONLY. What the whole run of an exercise's hidden scene is worth.
#pragma once

namespace grader {

// 0 for an exercise that no scene needs.
struct WholeRunPoints {
  double run = 0, pictures = 0;
};

}  // namespace grader
