#include "hair/lab/head/head_errors.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hair::head_study {

void HeadErrorTally::add(std::span<const double> made, std::span<const double> simulated) {
  const std::size_t numbers = 3 * static_cast<std::size_t>(points_);
  if (made.size() != simulated.size() || made.empty() || made.size() % numbers != 0)
    throw std::invalid_argument("hair of " + std::to_string(made.size()) + " and " +
                                std::to_string(simulated.size()) + " numbers; both must have the same, " +
                                std::to_string(numbers) + " for each strand");
  of_strands_.resize(made.size() / numbers);
  double sum = 0;
  for (std::size_t k = 0; k < of_strands_.size(); ++k) {
    double squares = 0;
    for (std::size_t i = k * numbers; i < (k + 1) * numbers; ++i)
      squares += (made[i] - simulated[i]) * (made[i] - simulated[i]);
    of_strands_[k] = std::sqrt(squares / points_);
    sum += squares / points_;
  }
  const std::size_t strands = of_strands_.size();
  const auto most = of_strands_.begin() + static_cast<std::ptrdiff_t>((95 * strands + 99) / 100 - 1);
  std::nth_element(of_strands_.begin(), most, of_strands_.end());
  const double mean = sum / static_cast<double>(strands);
  errors_.end = {std::sqrt(mean), *most};
  if (moments_++ == 0) {
    errors_.start = errors_.end;
    return;
  }
  squares_ += mean;
  errors_.rms = std::sqrt(squares_ / (moments_ - 1));
  errors_.highest = std::max(errors_.highest, *most);
}

}  // namespace hair::head_study
