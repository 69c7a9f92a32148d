// STAFF ONLY. The cases of each category of H7.
#include "reference/H7/cases.h"

namespace grader::h7 {

Cases cases() {
  return {{"Velocities", velocities},
          {"MovingJoints", moving_joints},
          {"LinkForces", link_forces},
          {"Inertias", inertias},
          {"Biases", biases},
          {"AddedBySteps", added_by_steps},
          {"Accelerations", accelerations},
          {"Trees", trees},
          {"LongChains", long_chains},
          {"OtherUnits", other_units},
          {"ValuesBefore", values_before},
          {"SphericalJoints", spherical_joints}};
}

}  // namespace grader::h7
