#include "hair/io/plot/work_precision.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/timing.h"

namespace hair {

namespace {

constexpr double kNoBetter = 0.98;  // times the previous error: half the step should at least halve it
constexpr std::size_t kStalls = 3;  // so often in a row

struct Logs {
  double error, time;
};

// The runs that no other run beats in both error and time, in the order of time.
std::vector<Logs> front_of(std::vector<Sample> samples, double least_error) {
  for (Sample& sample : samples) sample.error = std::max(sample.error, least_error);
  std::ranges::sort(samples, {}, [](const Sample& one) { return std::pair(one.seconds, one.error); });
  std::vector<Logs> front;
  double best = std::numeric_limits<double>::infinity();
  for (const Sample& sample : samples) {
    if (!(sample.error < best)) continue;
    best = sample.error;
    front.push_back({std::log(sample.error), std::log(sample.seconds)});
  }
  return front;
}

// The logarithm of the time for an error that the front reaches.
double time_at(const std::vector<Logs>& front, double error) {
  for (std::size_t i = 1; i < front.size(); ++i) {
    const Logs &before = front[i - 1], &after = front[i];
    if (error < after.error) continue;
    const double part = std::clamp((before.error - error) / (before.error - after.error), 0.0, 1.0);
    return before.time + part * (after.time - before.time);
  }
  return front.back().time;
}

}  // namespace

std::optional<double> time_for(const std::vector<Sample>& samples, double error, double least_error) {
  const std::vector<Logs> front = front_of(samples, least_error);
  if (front.empty() || std::log(error) < front.back().error) return {};
  return std::exp(time_at(front, std::log(error)));
}

std::optional<double> time_ratio(const std::vector<Sample>& theirs, const std::vector<Sample>& ours,
                                 double least_error) {
  const std::vector<Logs> one = front_of(theirs, least_error), two = front_of(ours, least_error);
  if (one.empty() || two.empty()) return {};
  const double high = std::min(one.front().error, two.front().error);
  const double low = std::max(one.back().error, two.back().error);
  std::vector<double> ratios;
  for (const auto* front : {&one, &two})
    for (const Logs& at : *front)
      if (at.error >= low && at.error <= high)
        ratios.push_back(std::exp(time_at(one, at.error) - time_at(two, at.error)));
  if (ratios.empty()) return {};
  return timing::median(ratios);
}

bool stalls(const std::vector<double>& errors) {
  if (errors.size() <= kStalls) return false;
  for (std::size_t k = errors.size() - kStalls; k < errors.size(); ++k)
    if (!(errors[k] >= kNoBetter * errors[k - 1])) return false;
  return true;
}

void add_level(Figure& figure, const std::string& name, double error) {
  std::vector<double> xs;
  for (const Series& series : figure.series)
    for (const Point& point : series.points) xs.push_back(point.x);
  if (xs.empty()) return;
  const auto [low, high] = std::minmax_element(xs.begin(), xs.end());
  figure.series.push_back({name, {{*low, error}, {*high, error}}, true, false, true});
}

}  // namespace hair
