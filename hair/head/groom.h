// Groomed hair: each strand is a list of points.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace hair {

struct Groom {
  std::vector<Eigen::VectorXd>
      strands;  // 3n numbers each, n >= 2, from the root to the tip; in the file's unit
};

}  // namespace hair
