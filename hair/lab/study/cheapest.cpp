#include "hair/lab/study/cheapest.h"

#include <algorithm>
#include <cmath>

namespace hair {

std::optional<double> time_for(const Sweep& sweep, Norm norm, double error) {
  const auto gets_there = [&](const MethodRun& run) {
    return run.ending == RunEnding::finished && run.errors[norm] <= error;
  };
  // The coarsest run from which on all get there.
  std::size_t first = sweep.runs.size();
  while (first > 0 && gets_there(sweep.runs[first - 1])) --first;
  if (first == sweep.runs.size()) return {};
  const MethodRun& after = sweep.runs[first];
  if (first == 0 || sweep.runs[first - 1].ending != RunEnding::finished) return after.time();

  const MethodRun& before = sweep.runs[first - 1];
  if (!(after.errors[norm] > 0) || after.time() <= before.time()) return after.time();
  const double way =
      std::log(before.errors[norm] / error) / std::log(before.errors[norm] / after.errors[norm]);
  return before.time() * std::pow(after.time() / before.time(), way);
}

std::vector<Cost> costs_for(const Study& study, Norm norm, double error) {
  std::vector<Cost> costs;
  for (std::size_t i = 0; i < study.sweeps.size(); ++i)
    if (const auto seconds = time_for(study.sweeps[i], norm, error))
      costs.push_back({static_cast<int>(i), *seconds});
  std::sort(costs.begin(), costs.end(), [](const Cost& a, const Cost& b) { return a.seconds < b.seconds; });
  return costs;
}

}  // namespace hair
