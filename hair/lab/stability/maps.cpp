#include "hair/lab/stability/maps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hair/lab/stability/theory.h"
#include "solver/timing.h"

namespace hair {

namespace {

constexpr double kSofter = 1e-2, kStiffer = 1e2;  // relative to the scene's stiffness

std::vector<double> logarithmic(double low, double high, int count) {
  std::vector<double> values(count);
  for (int i = 0; i < count; ++i) values[i] = low * std::pow(high / low, (i + 0.5) / count);
  return values;
}

long steps_of(const StudyMethod& method, const MapSettings& settings) {
  return method.is_explicit() ? settings.evaluations / row_of(method.method).evaluations
                              : settings.implicit_steps;
}

std::string limit_name(const StudyMethod& method) {
  const std::string limit = row_of(method.method).limit;
  return limit.empty() ? "theory" : "theory: " + limit;
}

// A column of a map: hair that hangs, with one stiffness and one drag.
struct Station {
  Hanging hanging;
  Disturbance disturbance;
  double drag;
};

// The largest step with which nothing grows by more than `growth` in a step; infinity if H6's is above
// `most`.
double limit_of(const Description& hair, const StudyMethod& method, const Station& station, double growth,
                double most) {
  const Hanging& hanging = station.hanging;
  const Modes &along = hanging.along_modes, &across = hanging.across_modes;
  const double gamma = hanging.drag_per_mass * station.drag;
  if (method.is_explicit()) {
    double least = std::numeric_limits<double>::infinity();
    for (const Modes* modes : {&along, &across})
      for (const double omega : modes->omega)
        least = std::min(least, explicit_limit(method.method, {omega, gamma}, growth));
    return least;
  }
  const ProductParts products = products_of(hair, hanging, method.geometric_term, method.bend_product);
  if (hanging.keeps_lengths)
    return predictor_corrector_limit(hanging.mass, across.stiffness, products.across, gamma, most, growth);
  return std::min(implicit_limit(hanging.mass, along.stiffness, products.along, gamma, growth),
                  implicit_limit(hanging.mass, across.stiffness, products.across, gamma, growth));
}

std::vector<Limit> limits_of(const Description& hair, const StudyMethod& method,
                             const std::vector<Station>& stations, const std::vector<double>& hs,
                             long steps) {
  Limit limit{limit_name(method), {}, false};
  Limit shown{"theory: what " + std::to_string(steps) + " steps show", {}, true};
  const double growth = std::pow(kWrongGrowth, 0.5 / static_cast<double>(steps));
  bool differs = false;
  for (const Station& station : stations) {
    const double most = 4 * hs.back(), h = limit_of(hair, method, station, 1, most),
                 later = limit_of(hair, method, station, growth, most);
    limit.h.push_back(h);
    shown.h.push_back(later);
    // The distance is half a cell, somewhere on the map.
    differs = differs || (h < hs.back() && later * later * hs[0] > h * h * hs[1]);
  }
  if (!differs) return {limit};
  return {limit, shown};
}

}  // namespace

std::vector<double> boundary_of(const RefinedGrid& grid, const std::vector<double>& hs) {
  const std::size_t rows = hs.size(), columns = grid.cells.size() / rows;
  std::vector<double> boundary(columns, std::numeric_limits<double>::infinity());
  for (std::size_t column = 0; column < columns; ++column)
    for (std::size_t row = 0; row < rows; ++row)
      if (grid.cells[row * columns + column] >= static_cast<int>(Fate::wrong)) {
        boundary[column] = row == 0 ? 0 : std::sqrt(hs[row - 1] * hs[row]);
        break;
      }
  return boundary;
}

Distance distance_of(const std::vector<double>& boundary, const std::vector<double>& limit,
                     const std::vector<double>& hs) {
  const double cell = std::log(hs[1] / hs[0]);
  const double lowest = std::sqrt(hs[0] * hs[0] * hs[0] / hs[1]);  // the lower edge, by half a cell
  const auto on_map = [&](double h) { return std::clamp(h, hs.front(), hs.back()); };
  Distance distance;
  std::vector<double> distances;
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    if (boundary[i] > 0 && std::isfinite(boundary[i]) && limit[i] > lowest && limit[i] < hs.back()) {
      distances.push_back(std::log(boundary[i] / limit[i]) / cell);
      continue;
    }
    const double at_least = std::log(on_map(boundary[i]) / on_map(limit[i])) / cell;
    if (std::abs(at_least) <= 1) continue;
    ++distance.columns_beyond;
    if (std::abs(at_least) > std::abs(distance.beyond_cells)) distance.beyond_cells = at_least;
  }
  distance.columns = static_cast<int>(distances.size());
  if (distances.empty()) return distance;
  distance.worst_cells =
      *std::ranges::max_element(distances, [](double a, double b) { return std::abs(a) < std::abs(b); });
  std::nth_element(distances.begin(), distances.begin() + distances.size() / 2, distances.end());
  distance.median_cells = distances[distances.size() / 2];
  distance.median_relative = std::expm1(distance.median_cells * cell);
  return distance;
}

bool alike_when_hanging(const Description& hair, const StudyMethod& a, const StudyMethod& b) {
  if (a.method != b.method || a.is_explicit()) return false;
  for (const double stiffness : {kSofter, 1.0, kStiffer}) {
    const Hanging hanging = hang(with_options(hair, a), stiffness, false);
    const ProductParts first = products_of(with_options(hair, a), hanging, a.geometric_term, a.bend_product);
    const ProductParts second = products_of(with_options(hair, b), hanging, b.geometric_term, b.bend_product);
    const auto differ = [](const Eigen::MatrixXd& p, const Eigen::MatrixXd& q) {
      return (p - q).norm() > 1e-9 * p.norm();
    };
    if (differ(first.along, second.along) || differ(first.across, second.across)) return false;
  }
  return true;
}

StabilityMap make_map(const Description& hair, const StudyMethod& method, Swept sweep,
                      const MapSettings& settings, const std::atomic<bool>& interrupted,
                      const Progress& progress) {
  const double start = timing::cpu_seconds();
  const Description description = with_options(hair, method);
  // The map's axes count from the fastest oscillation; of implicit methods, the fastest that tension holds.
  const Hanging as_it_is = hang(description, 1, false);
  const double omega = method.is_explicit() ? as_it_is.fastest() : fastest_by_tension(description, as_it_is);
  const double critical_drag = 2 * omega / as_it_is.drag_per_mass;  // damps that oscillation critically
  StabilityMap map;
  map.method = method;
  map.sweep = sweep;
  map.steps = steps_of(method, settings);
  map.hs = method.is_explicit() ? logarithmic(3e-3 / omega, 60 / omega, settings.rows)
                                : logarithmic(0.04 / omega, 40 / omega, settings.rows);
  const bool in_stiffness = sweep == Swept::stiffness;
  map.xs = in_stiffness ? logarithmic(kSofter, kStiffer, settings.columns)
                        : logarithmic(1e-2 * critical_drag, 10 * critical_drag, settings.columns);
  std::vector<Station> stations;
  for (const double x : map.xs) {
    Hanging hanging = hang(description, in_stiffness ? x : 1, row_of(method.method).keeps_lengths);
    Disturbance disturbance = disturb(hanging);
    stations.push_back({std::move(hanging), std::move(disturbance), in_stiffness ? description.drag : x});
  }
  long runs = 0;
  map.grid = refine(
      settings.columns, settings.rows,
      [&](int column, int row) {
        const Station& at = stations[column];
        const Outcome outcome =
            run_disturbed(description, at.hanging, at.disturbance, at.drag, map.hs[row], map.steps);
        if (progress) progress(++runs);
        return static_cast<int>(outcome.fate);
      },
      interrupted);
  map.boundary = boundary_of(map.grid, map.hs);
  map.limits = limits_of(description, method, stations, map.hs, map.steps);
  for (Limit& limit : map.limits) limit.distance = distance_of(map.boundary, limit.h, map.hs);
  map.cpu_seconds = timing::cpu_seconds() - start;
  return map;
}

}  // namespace hair
