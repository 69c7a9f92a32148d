// The observed order of a method: p in error ~ h^p.
#pragma once

#include <optional>

#include "hair/lab/study/study.h"

namespace hair {

struct ObservedOrder {
  // The mean of log2(error at h / error at h/2) over the finest two or more consecutive halvings that agree
  // within 0.25, or none. Halvings that make no difference are ignored. Runs with an error below 10 times the
  // floor don't count, because the reference's own error affects them.
  std::optional<double> order;
  double coarsest = 0, finest = 0;  // s, the range of steps of this order

  // m, the level at which errors stagnate: the last two halvings changed them by less than a tenth of an
  // order.
  std::optional<double> stays_at;
};

ObservedOrder observed_order(const Sweep& sweep, Norm norm, double floor);

// "as theory has it", or a few words about the deviation.
std::string verdict(const Sweep& sweep, const ObservedOrder& observed);

}  // namespace hair
