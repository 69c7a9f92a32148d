// STAFF ONLY. Makes vectors of random entries.
#pragma once

#include <Eigen/Core>

#include "grader/judge/cases/random.h"

namespace grader::inline judge {

// Draws normal entries of size `scale`.
inline Eigen::VectorXd random_vector(Random& random, Eigen::Index size, double scale = 1) {
  Eigen::VectorXd v(size);
  for (double& entry : v) entry = scale * random.normal();
  return v;
}

}  // namespace grader::judge
