// STAFF ONLY.
#include "grader/exercise/H7/cases.h"

namespace grader::h7 {

std::vector<Category> categories() {
  return {{"Velocities", "Pass 1: velocities", 3, velocities},
          {"MovingJoints", "Pass 1: accelerations of joints that move", 4, moving_joints},
          {"LinkForces", "Pass 1: forces on links", 2, link_forces},
          {"Inertias", "Pass 2: articulated inertias", 3, inertias},
          {"Biases", "Pass 2: articulated bias forces", 3, biases},
          {"Gains", "Pass 2: gains and stiffening", 2, gains},
          {"Accelerations", "Pass 3: accelerations", 3, accelerations},
          {"EquationsOfMotion", "The equations of motion", 2, equations_of_motion},
          {"Trees", "Trees", 1, trees},
          {"LongChains", "Long chains, light links and fast ones", 1, long_chains},
          {"SphericalJoints", "Spherical joints", 2, spherical_joints}};
}

}  // namespace grader::h7
