// STAFF ONLY. The reference solution of a part's motion, against which errors are measured. It is the same
// for a class, and is stored.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/judge/study/parts.h"
#include "particles/state.h"

namespace grader::inline judge {

struct Truth {
  std::vector<particles::State> frames;  // belong to the part's scene; the first is the start
  double size = 0;                       // m: the diagonal of the motion's bounding box
  double least_error = 0;                // m: smaller errors are meaningless
  std::string method;                    // "CVODE 6.4.1 (BDF), relative tolerance 1e-12"
};

// The accurate solution of the equations of motion if there is one (hair/truth/accurate_motion.h).
// Otherwise (several strands, hair with obstacles, or rods and wires) the reference itself, with many times
// the steps of the finest division. `kept` is a folder for stored motions. Throws std::runtime_error if the
// reference breaks.
Truth true_motion(const StudiedPart& part, const std::optional<std::filesystem::path>& kept);

}  // namespace grader::judge
