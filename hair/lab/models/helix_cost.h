// What H8's functions cost against the number of elements: a step may grow linearly, a matrix grows with the square.
#pragma once

#include <atomic>
#include <optional>
#include <vector>

namespace hair::model_study {

struct HelixCost {
  int elements;
  double step, mass_matrix;  // s of CPU time: helix_step; mass_matrix, which a step may do without
};

// Of a curl of as many elements as turns, from 1 to 160; fewer if `quick`. Empty if `interrupted`. The course has H8.
std::optional<std::vector<HelixCost>> helix_costs(bool quick, const std::atomic<bool>& interrupted);

}  // namespace hair::model_study
