// STAFF ONLY.
#include "grader/exercise/H5/cases.h"
#include "grader/suite/whole_run_points.h"

namespace grader::h5 {

WholeRunPoints whole_run() {
  return {2, 3};
}

std::vector<Category> categories() {
  return {{"Relaxation", "Relaxation of lengths", 2, relaxation},
          {"RelaxationMasses", "Relaxation by masses", 2, relaxation_masses},
          {"Lengths", "Lengths, corrected", 2, lengths},
          {"Impulses", "Impulses along the segments", 2, impulses},
          {"Masses", "Masses", 1, masses},
          {"Distance", "The distance moved", 1, distance},
          {"Root", "The root", 2, root},
          {"Report", "The report", 2, report},
          {"Velocities", "Velocities", 2, velocities},
          {"VelocityImpulses", "Impulses on velocities", 2, velocity_impulses},
          {"Degenerate", "Folds, points and single particles", 1, degenerate},
          {"LongStrands", "Long strands", 1, long_strands}};
}

}  // namespace grader::h5
