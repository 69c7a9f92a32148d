#include "hair/io/plot/work_precision.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/timing.h"

namespace hair {

namespace {

constexpr double kNoBetter = 0.98;  // times the previous error: half the step should at least halve it
constexpr std::size_t kStalls = 3;  // so often in a row

struct Logs {
  double error, time;
};

// Samples, each with a smaller error and a longer time than the previous one.
std::vector<Logs> front_of(std::vector<Sample> samples, double least_error) {
  for (Sample& sample : samples) sample.error = std::max(sample.error, least_error);
  std::vector<Logs> front;
  for (const std::size_t i : best_of(samples))
    front.push_back({std::log(samples[i].error), std::log(samples[i].seconds)});
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

std::vector<std::size_t> best_of(const std::vector<Sample>& samples) {
  std::vector<std::size_t> all(samples.size()), best;
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::sort(all.begin(), all.end(), [&](std::size_t i, std::size_t k) {
    const Sample &a = samples[i], &b = samples[k];
    return a.seconds != b.seconds ? a.seconds < b.seconds : a.error < b.error;
  });
  for (const std::size_t i : all)
    if (best.empty() || samples[i].error < samples[best.back()].error) best.push_back(i);
  return best;
}

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
