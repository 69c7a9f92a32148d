// STAFF ONLY. The reference solution of a part's motion, against which errors are measured. It is the same
// for a class, and is stored.
#pragma once

#include <filesystem>
#include <optional>

#include "grader/judge/study/scenes.h"
#include "hair/truth/accurate_motion.h"

namespace grader::inline judge {

struct Truth {
  hair::AccurateMotion motion;  // its states are the frames of the part's scene; the first is the start
  double size = 0;              // m: the diagonal of the motion's bounding box
};

// The accurate solution of the equations of motion if there is one (hair/truth/accurate_motion.h). Otherwise
// (several strands, or hair with obstacles) the reference itself, with many times the steps of the finest
// division. `kept` is a folder for stored motions. Throws std::runtime_error if the reference breaks.
Truth true_motion(const StudiedPart& part, const std::optional<std::filesystem::path>& kept);

}  // namespace grader::judge
