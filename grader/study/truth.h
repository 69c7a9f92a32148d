// STAFF ONLY. Where the particles of a part really are: what errors are measured against. The same for a class, and kept.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/study/parts.h"
#include "particles/state.h"

namespace grader {

struct Truth {
  std::vector<particles::State> frames;  // of the part's scene, its start the first
  double size = 0;                       // m: the diagonal of the box that holds all of it
  double least_error = 0;                // m: what is nearer than this says nothing
  std::string method;                    // "CVODE 6.4.1 (BDF), relative tolerance 1e-12"
};

// The accurate solution of the equations of motion where there is one (hair/truth/accurate_motion.h); else, of several
// strands, of hair that meets obstacles, or of rods and wires, the reference itself with many times the steps of the
// finest division.
// `kept` is a folder for what was found once. Throws std::runtime_error if the reference breaks.
Truth true_motion(const StudiedPart& part, const std::optional<std::filesystem::path>& kept);

}  // namespace grader
