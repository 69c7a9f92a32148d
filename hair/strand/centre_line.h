// Points of a centre line by arc length, so that lines with different numbers of points can be compared.
#pragma once

#include "hair/strand.h"
#include "particles/vectors.h"

namespace hair {

// The arc lengths of a strand's particles at rest, from the root: n numbers, m.
Eigen::VectorXd arc_lengths(const Strand& strand);

// The points at the arc lengths `wanted`. x: 3n numbers, m, the points of a line; at: their n arc lengths, m,
// increasing. Between two points the line is straight: on a curve of curvature k, with points l apart, the
// result is off by up to k l^2 / 8. At the arc length of a point (to within 1e-12 of the whole) the result is
// that point, bit for bit. Throws std::invalid_argument for sizes that do not fit, and for arc lengths
// outside of the line.
Eigen::VectorXd points_at(particles::Input x, particles::Input at, particles::Input wanted);

}  // namespace hair
