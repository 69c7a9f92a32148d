#include "hair/strand/centre_line.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "particles/require.h"

namespace hair {

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
