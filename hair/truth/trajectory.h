// The motion of a problem's particles: their states at each of its moments.
#pragma once

#include <vector>

#include "particles/state.h"

namespace hair {

// states[k] is at time duration * k / moments; states[0] is the start.
using Trajectory = std::vector<particles::State>;

// The largest distance of a particle between two states, m; for trajectories, over all moments that both
// have.
double largest_distance(const Eigen::VectorXd& x, const Eigen::VectorXd& y);
double largest_distance(const Trajectory& a, const Trajectory& b);

}  // namespace hair
