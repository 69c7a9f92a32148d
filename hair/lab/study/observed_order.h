// The order of a method as its runs show it: p in error ~ h^p.
#pragma once

#include <optional>
#include <vector>

#include "hair/lab/study/study.h"

namespace hair {

struct ObservedOrder {
  // The mean of log2(error at h / error at h/2) over the finest two or more halvings in a row that agree to
  // within 0.25 (those that make no difference left aside), or none. Runs nearer to the floor than 10 times
  // it don't count: there the reference's own error shows.
  std::optional<double> order;
  double coarsest = 0, finest = 0;  // s, the steps between which that was seen

  // m, where errors stay: the last two halvings made no difference worth a tenth of an order.
  std::optional<double> stays_at;
};

ObservedOrder observed_order(const Sweep& sweep, Norm norm, double floor);

// "as theory has it", or what is wrong, in a few words.
std::string verdict(const Sweep& sweep, const ObservedOrder& observed);

}  // namespace hair
