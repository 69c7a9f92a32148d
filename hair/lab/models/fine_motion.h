// The motion that strand models are compared with: that of an inextensible rod which bends and twists (Kirchhoff's), as two
// fine chains of rigid links, of n and 2n, have it. Their error falls with the square of the links' length, so that the limit
// is x_2n + (x_2n - x_n) / 3 (Richardson), and is known to about |x_2n - x_n| / 3. Steps of RK4 are short enough that
// the links don't ring, and then their error in time does not count.
#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "hair/lab/models/compared_hair.h"

namespace hair::model_study {

struct FineMotion {
  std::vector<Eigen::VectorXd>
      lines;               // at each moment: the points at the root and at the ends of elements[0] elements
  double uncertainty = 0;  // m, root mean square over points and moments
  double seconds = 0;      // CPU time that it took
};

// Empty if `interrupted`. Calls H7.
std::optional<FineMotion> fine_motion(const ComparedHair& hair, const std::atomic<bool>& interrupted);

// The points of such a line out of a body's centre line x, whose points lie at the arc lengths `at`: those that it has there,
// or else the cubic through the four around.
Eigen::VectorXd compared_points(const ComparedHair& hair, const Eigen::VectorXd& x,
                                const Eigen::VectorXd& at);

// The root mean square distance of points over all moments, m.
double rms_distance(const std::vector<Eigen::VectorXd>& lines, const std::vector<Eigen::VectorXd>& others);

}  // namespace hair::model_study
