#include "hair/groom/resample.h"

#include <algorithm>

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
  GroomLook& look = groom.look;
  std::vector<float> thicknesses, transparencies, colours;
  std::size_t first = 0;  // this strand's first point among all points
  for (Eigen::VectorXd& x : groom.strands) {
    const auto before = static_cast<std::size_t>(points_of(x));
    const std::vector<Place> places = before < 2 ? std::vector<Place>{{0, 0}} : equal_places(x, points);
    const auto resample_into = [&](std::vector<float>& to, const std::vector<float>& from, std::size_t size) {
      if (from.empty()) return;
      for (const Place& place : places)
        for (std::size_t k = 0; k < size; ++k) {
          const std::size_t at = size * (first + static_cast<std::size_t>(place.before)) + k;
          to.push_back(place.part == 0 ? from[at] : between(from[at], from[at + size], place.part));
        }
    };
    resample_into(thicknesses, look.thicknesses, 1);
    resample_into(transparencies, look.transparencies, 1);
    resample_into(colours, look.colours, 3);
    first += before;
    if (before >= 2) x = resampled(x, points);
  }
  look.thicknesses = std::move(thicknesses);
  look.transparencies = std::move(transparencies);
  look.colours = std::move(colours);
}

}  // namespace hair
