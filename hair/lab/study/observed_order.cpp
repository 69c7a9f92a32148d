#include "hair/lab/study/observed_order.h"

#include <algorithm>
#include <cmath>

#include "hair/io/plot/page.h"

namespace hair {

namespace {

constexpr double kSafe = 10;     // times the floor: an error of the reference shifts an order by 0.15 at most
constexpr double kAgree = 0.25;  // difference of two orders
constexpr double kFlat = 0.1;    // order of a flat halving
constexpr double kAsTheory = 0.25;  // difference of an order from theory's

struct Halving {
  double order, before, after;  // and the steps, s
};

// The halvings between finished runs, coarse to fine.
std::vector<Halving> halvings(const std::vector<MethodRun>& runs, Norm norm, double least) {
  std::vector<Halving> found;
  for (std::size_t k = 1; k < runs.size(); ++k) {
    const MethodRun &before = runs[k - 1], &after = runs[k];
    if (before.ending != RunEnding::finished || after.ending != RunEnding::finished) continue;
    if (!(after.errors[norm] >= least) || !(before.errors[norm] >= least)) continue;
    found.push_back({std::log2(before.errors[norm] / after.errors[norm]), before.step, after.step});
  }
  return found;
}

}  // namespace

ObservedOrder observed_order(const Sweep& sweep, Norm norm, double floor) {
  ObservedOrder observed;
  const std::vector<Halving> all = halvings(sweep.runs, norm, kSafe * floor);
  const int count = static_cast<int>(all.size());
  const auto flat = [&](int k) { return std::abs(all[k].order) < kFlat; };
  if (count >= 2 && flat(count - 1) && flat(count - 2)) observed.stays_at = sweep.runs.back().errors[norm];

  // Goes from the finest halving that is not flat to coarser ones, as long as these agree with it. Coarser
  // halvings that agree only with each other show no asymptotic order.
  int last = count - 1;
  while (last >= 0 && flat(last)) --last;
  int first = last;
  double sum = last >= 0 ? all[last].order : 0;
  while (first > 0 && std::abs(all[first - 1].order - all[last].order) <= kAgree) sum += all[--first].order;
  if (first < last && sum > 0) {
    observed.order = sum / (last - first + 1);
    observed.coarsest = all[first].before;
    observed.finest = all[last].after;
  }
  return observed;
}

std::string verdict(const Sweep& sweep, const ObservedOrder& observed) {
  const bool any =
      std::ranges::any_of(sweep.runs, [](const MethodRun& run) { return run.ending == RunEnding::finished; });
  if (!sweep.left_out.empty()) return "not written";
  if (!any) return "no run got to the end";
  if (observed.stays_at) return "stays " + to_text(*observed.stays_at) + " m off, however small the step";
  if (!observed.order) return "no order seen: not asymptotic";
  if (std::abs(*observed.order - sweep.method.order()) <= kAsTheory) return "as theory has it";
  return std::string(*observed.order < sweep.method.order() ? "less" : "more") + " than theory says";
}

}  // namespace hair
