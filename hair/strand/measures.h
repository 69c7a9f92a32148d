// Measures of a strand for studies and reports: its stretch, its energy, its momenta, and points of its
// centre line by arc length, so that lines with different numbers of points can be compared.
#pragma once

#include "hair/strand.h"
#include "particles/force.h"
#include "particles/state.h"
#include "particles/vectors.h"

namespace hair {

// The largest |l - l0| / l0 of all segments, 0 for a strand without segments. NaN if a length is NaN.
double largest_stretch(const Strand& strand, particles::Input x);

// The largest |u . (v_{i+1} - v_i)| / l0 of all segments, 1/s, u the segment's direction: the rate at which
// velocities stretch the strand. 0 for a strand without segments; a segment of length 0 has no direction, and
// no rate. NaN if a rate is NaN.
double largest_stretch_rate(const Strand& strand, particles::Input x, particles::Input v);

struct Measures {
  double stretch = 0;                 // largest_stretch
  double kinetic = 0, potential = 0;  // J
  Eigen::Vector3d momentum;           // kg m/s
  Eigen::Vector3d angular_momentum;   // kg m^2/s, about the root's position

  double energy() const { return kinetic + potential; }
};

// `force` is the sum of all forces on the strand, and gives the potential energy.
Measures measure(const Strand& strand, const particles::Particles& particles, const particles::Force& force,
                 const particles::State& state);

// The arc lengths of a strand's particles at rest, from the root: n numbers, m.
Eigen::VectorXd arc_lengths(const Strand& strand);

// The points at the arc lengths `wanted`. x: 3n numbers, m, the points of a line; at: their n arc lengths, m,
// increasing. Between two points the line is straight: on a curve of curvature k, with points l apart, the
// result is off by up to k l^2 / 8. At the arc length of a point (to within 1e-12 of the whole) the result is
// that point, bit for bit. Throws std::invalid_argument for sizes that do not fit, and for arc lengths
// outside of the line.
Eigen::VectorXd points_at(particles::Input x, particles::Input at, particles::Input wanted);

}  // namespace hair
