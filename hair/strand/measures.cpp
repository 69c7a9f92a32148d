#include "hair/strand/measures.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "particles/require.h"
#include "particles/system.h"

namespace hair {

double largest_stretch(const Strand& strand, particles::Input x) {
  double worst = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const Eigen::Vector3d along = x.segment<3>(3 * i + 3) - x.segment<3>(3 * i);
    const double stretch = std::abs(along.norm() / strand.rest_length[i] - 1);
    if (std::isnan(stretch)) return stretch;
    worst = std::max(worst, stretch);
  }
  return worst;
}

double largest_stretch_rate(const Strand& strand, particles::Input x, particles::Input v) {
  double largest = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const Eigen::Vector3d e = x.segment<3>(3 * i + 3) - x.segment<3>(3 * i);
    const double length = e.norm();
    if (length == 0) continue;
    const double along = e.dot(v.segment<3>(3 * i + 3) - v.segment<3>(3 * i)) / length;
    const double rate = std::abs(along) / strand.rest_length[i];
    if (!(rate <= largest)) largest = rate;
  }
  return largest;
}

Measures measure(const Strand& strand, const particles::Particles& particles, const particles::Force& force,
                 const particles::State& state) {
  Measures measures;
  measures.stretch = largest_stretch(strand, state.x);
  measures.kinetic = particles::kinetic_energy(particles, state.v);
  measures.potential = force.energy(state.x);
  measures.momentum = particles::momentum(particles, state.v);
  measures.angular_momentum = particles::angular_momentum(particles, state.x, state.v, state.x.head<3>());
  return measures;
}

using particles::require;

Eigen::VectorXd arc_lengths(const Strand& strand) {
  Eigen::VectorXd at = Eigen::VectorXd::Zero(strand.count());
  for (int i = 0; i < strand.segments(); ++i) at[i + 1] = at[i] + strand.rest_length[i];
  return at;
}

Eigen::VectorXd points_at(particles::Input x, particles::Input at, particles::Input wanted) {
  const Eigen::Index n = at.size();
  require(n >= 1 && x.size() == 3 * n, "the numbers in x", static_cast<double>(x.size()),
          std::to_string(3 * n));
  const double near = 1e-12 * (at[n - 1] - at[0]);
  Eigen::VectorXd points(3 * wanted.size());
  for (Eigen::Index k = 0; k < wanted.size(); ++k) {
    const double s = wanted[k];
    require(s >= at[0] - near && s <= at[n - 1] + near, "an arc length", s,
            "on the line, which ends at " + std::to_string(at[n - 1]));
    // The first point at or after s, and the one before it.
    const Eigen::Index after =
        std::min<Eigen::Index>(std::lower_bound(at.begin(), at.end(), s - near) - at.begin(), n - 1);
    if (std::abs(at[after] - s) <= near || after == 0) {
      points.segment<3>(3 * k) = x.segment<3>(3 * after);
      continue;
    }
    const double part = (s - at[after - 1]) / (at[after] - at[after - 1]);
    points.segment<3>(3 * k) = (1 - part) * x.segment<3>(3 * after - 3) + part * x.segment<3>(3 * after);
  }
  return points;
}

}  // namespace hair
