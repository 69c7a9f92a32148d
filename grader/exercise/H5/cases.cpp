// STAFF ONLY. H5: its categories. Equal masses, segments of about 1 m and a root that is too heavy to move keep from most of them what
// is asked in others: by what masses particles move, in what unit an error is, whether the root moves.
#include "grader/exercise/H5/cases.h"
#include "grader/suite/whole_run_points.h"

namespace grader::h5 {

WholeRunPoints whole_run() {
  return {1, 1};
}

std::vector<Category> categories() {
  return {{"Relaxation", "Relaxation of lengths", 3, relaxation},
          {"Lengths", "Lengths, corrected", 3, lengths},
          {"Impulses", "Impulses along the segments", 2, impulses},
          {"Velocities", "Velocities", 4, velocities},
          {"Masses", "Masses", 2, masses},
          {"Root", "The root", 2, root},
          {"Report", "The report", 2, report},
          {"Iterations", "Few iterations", 1, iterations},
          {"Degenerate", "Folds, points and single particles", 1, degenerate},
          {"FarRoot", "A root that was flung away", 1, far_root},
          {"Units", "Errors relative to the length", 1, units},
          {"LongStrands", "Long strands", 1, long_strands}};
}

}  // namespace grader::h5
