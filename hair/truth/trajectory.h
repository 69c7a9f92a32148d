// How a problem's particles moved: their state at each of its moments.
#pragma once

#include <vector>

#include "particles/state.h"

namespace hair {

// states[k] is at time duration * k / moments; states[0] is the start.
using Trajectory = std::vector<particles::State>;

// Of all particles the largest distance between where it is in one and in the other, m; of trajectories, at any moment
// that both have.
double largest_distance(const Eigen::VectorXd& x, const Eigen::VectorXd& y);
double largest_distance(const Trajectory& a, const Trajectory& b);

}  // namespace hair
