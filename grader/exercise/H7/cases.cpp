// STAFF ONLY. The categories of H7 and their weights.
#include "grader/exercise/H7/cases.h"

namespace grader::h7 {

std::vector<Category> categories() {
  return {{"Velocities", "Pass 1: velocities", 3, velocities},
          {"MovingJoints", "Pass 1: accelerations of joints that move", 4, moving_joints},
          {"LinkForces", "Pass 1: forces on links", 2, link_forces},
          {"Inertias", "Pass 2: articulated inertias and gains", 4, inertias},
          {"Biases", "Pass 2: articulated bias forces", 3, biases},
          {"AddedBySteps", "Pass 2: what implicit steps add", 1, added_by_steps},
          {"Accelerations", "Pass 3: accelerations", 3, accelerations},
          {"Trees", "Trees", 1, trees},
          {"LongChains", "Long chains", 1, long_chains},
          {"OtherUnits", "Links of any size, weight and speed", 1, other_units},
          {"ValuesBefore", "The base's inertia, and values from before", 1, values_before},
          {"SphericalJoints", "Spherical joints", 2, spherical_joints}};
}

}  // namespace grader::h7
