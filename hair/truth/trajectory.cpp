#include "hair/truth/trajectory.h"

#include <algorithm>

namespace hair {

double largest_distance(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  double largest = 0;
  for (Eigen::Index i = 0; i < x.size(); i += 3)
    largest = std::max(largest, (x.segment<3>(i) - y.segment<3>(i)).norm());
  return largest;
}

double largest_distance(const Trajectory& a, const Trajectory& b) {
  double largest = 0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
    largest = std::max(largest, largest_distance(a[k].x, b[k].x));
  return largest;
}

}  // namespace hair
