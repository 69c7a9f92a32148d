// STAFF ONLY.
#include "grader/suite/study/equal_error.h"

#include <algorithm>
#include <cmath>

#include "grader/result/study.h"
#include "solver/timing.h"

namespace grader {
namespace {

struct Logs {
  double error, time;
};

// Larger error to smaller, each in more time than the one before: runs that are beaten in both are left out.
std::vector<Logs> front(const std::vector<Sample>& samples, double least_error) {
  std::vector<Logs> all;
  for (const Sample& sample : samples)
    all.push_back({std::log(std::max(sample.error, least_error)), std::log(sample.seconds)});
  std::sort(all.begin(), all.end(), [](const Logs& a, const Logs& b) {
    return a.time != b.time ? a.time < b.time : a.error < b.error;
  });
  std::vector<Logs> best;
  for (const Logs& one : all)
    if (best.empty() || one.error < best.back().error) best.push_back(one);
  return best;
}

// Of an error that the front spans.
double time_for(const std::vector<Logs>& front, double error) {
  for (std::size_t i = 1; i < front.size(); ++i) {
    const Logs &before = front[i - 1], &after = front[i];
    if (error < after.error) continue;
    const double part = std::clamp((before.error - error) / (before.error - after.error), 0.0, 1.0);
    return before.time + part * (after.time - before.time);
  }
  return front.back().time;
}

}  // namespace

std::optional<double> time_ratio(const std::vector<Sample>& theirs, const std::vector<Sample>& ours,
                                 double least_error) {
  const std::vector<Logs> one = front(theirs, least_error), two = front(ours, least_error);
  if (one.empty() || two.empty()) return {};
  const double high = std::min(one.front().error, two.front().error);
  const double low = std::max(one.back().error, two.back().error);
  std::vector<double> ratios;
  for (const auto* samples : {&one, &two})
    for (const Logs& sample : *samples)
      if (sample.error >= low && sample.error <= high)
        ratios.push_back(std::exp(time_for(one, sample.error) - time_for(two, sample.error)));
  if (ratios.empty()) return {};
  return timing::median(ratios);
}

}  // namespace grader
