#include "hair/groom/resample.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hair {

namespace {

// A place on a line: `part` of the way from point `before` to the next.
struct Place {
  Eigen::Index before;
  double part;
};

std::vector<Place> equal_places(const Eigen::VectorXd& x, int points) {
  const Eigen::Index segments = points_of(x) - 1;
  std::vector<double> until(static_cast<std::size_t>(segments) + 1, 0.0);  // the length up to each point
  for (Eigen::Index k = 0; k < segments; ++k)
    until[static_cast<std::size_t>(k) + 1] =
        until[static_cast<std::size_t>(k)] + (x.segment<3>(3 * k + 3) - x.segment<3>(3 * k)).norm();
  const double length = until.back(), rounding = 1e-12 * length;
  std::vector<Place> places = {{0, 0}};
  Eigen::Index k = 0;
  for (int i = 1; i + 1 < points; ++i) {
    const double s = length * i / (points - 1);
    while (k + 1 < segments && until[static_cast<std::size_t>(k) + 1] <= s) ++k;
    const double from = until[static_cast<std::size_t>(k)], to = until[static_cast<std::size_t>(k) + 1];
    places.push_back({k, s - from <= rounding ? 0 : to - s <= rounding ? 1 : (s - from) / (to - from)});
  }
  places.push_back({segments - 1, 1});
  return places;
}

// Exact at both ends of a segment.
template <class Value>
Value between(const Value& before, const Value& after, double part) {
  if (part == 0) return before;
  if (part == 1) return after;
  return static_cast<Value>((1 - part) * before + part * after);
}

}  // namespace

Eigen::VectorXd resampled(const Eigen::VectorXd& x, int points) {
  const std::vector<Place> places = equal_places(x, points);
  Eigen::VectorXd result(3 * static_cast<Eigen::Index>(points));
  for (std::size_t i = 0; i < places.size(); ++i)
    for (Eigen::Index k = 0; k < 3; ++k)
      result[3 * static_cast<Eigen::Index>(i) + k] =
          between(x[3 * places[i].before + k], x[3 * places[i].before + 3 + k], places[i].part);
  return result;
}

void resample(Groom& groom, int points) {
  const auto old = numbers_of_points(groom.look);
  std::array<std::vector<float>, 3> made;
  std::size_t first = 0;  // this strand's first point among all points
  for (Eigen::VectorXd& x : groom.strands) {
    const auto before = static_cast<std::size_t>(points_of(x));
    const std::vector<Place> places = before < 2 ? std::vector<Place>{{0, 0}} : equal_places(x, points);
    for (std::size_t part = 0; part < made.size(); ++part) {
      const std::vector<float>& from = *old[part];
      const std::size_t size = parts_of(groom.look)[part].size;
      for (const Place& place : places)
        for (std::size_t k = 0; k < size && !from.empty(); ++k) {
          const std::size_t at = size * (first + static_cast<std::size_t>(place.before)) + k;
          made[part].push_back(place.part == 0 ? from[at] : between(from[at], from[at + size], place.part));
        }
    }
    first += before;
    if (before >= 2) x = resampled(x, points);
  }
  for (std::size_t part = 0; part < made.size(); ++part) *old[part] = std::move(made[part]);
}

void scale(Groom& groom, double factor) {
  for (Eigen::VectorXd& x : groom.strands) x *= factor;
  const auto to_unit = [&](float& thickness) {
    thickness = static_cast<float>(factor * static_cast<double>(thickness));
  };
  if (groom.look.thickness) to_unit(*groom.look.thickness);
  for (float& thickness : groom.look.thicknesses) to_unit(thickness);
}

void keep_every(Groom& groom, long every) {
  const auto step = static_cast<std::size_t>(every);
  for (std::size_t part = 0; part < 3; ++part) {
    std::vector<float>& numbers = *numbers_of_points(groom.look)[part];
    if (numbers.empty()) continue;
    const auto size = static_cast<std::ptrdiff_t>(parts_of(groom.look)[part].size);
    std::vector<float> kept;
    auto begin = numbers.begin();
    for (std::size_t i = 0; i < groom.strands.size(); ++i) {
      const auto end = begin + size * points_of(groom.strands[i]);
      if (i % step == 0) kept.insert(kept.end(), begin, end);
      begin = end;
    }
    numbers = std::move(kept);
  }
  std::vector<Eigen::VectorXd> kept;
  for (std::size_t i = 0; i < groom.strands.size(); i += step) kept.push_back(std::move(groom.strands[i]));
  groom.strands = std::move(kept);
}

}  // namespace hair
