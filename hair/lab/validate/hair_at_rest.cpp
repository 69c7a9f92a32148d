// Hair that is clamped level and bends under its own weight, at rest, beside the elastica: the error against
// the number of segments.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "hair/lab/validate/clamped_hair.h"
#include "hair/lab/validate/elastica.h"
#include "hair/lab/validate/planar_statics.h"
#include "hair/lab/validate/validations.h"

namespace hair {

namespace {

struct Rest {
  int segments;
  double error;  // the tip's, over L; NaN if no balance was found

  // The fourth-order curve of the strand, over L; 0 if the strand has too few segments for it.
  double expected = 0;   // the tip's error
  double apart = 0;      // the distance of the two tips
  double tolerance = 0;  // the largest allowed distance
};

// Hair of one length in more and more segments.
struct SegmentSweep {
  double gamma, length, stretch;
  std::vector<Rest> rests;
};

Rest find_rest(const Material& material, const SegmentSweep& sweep, int segments) {
  const StrandStart start = clamped_hair(material, segments, sweep.length, Vector3d::UnitX());
  const auto strand = under_gravity(start, Vector3d(0, 0, -kEarthGravity));
  const Eigen::Vector2d tip =
      tip_of(planar_balance(strand->strand, strand->force, start.state.x)) / sweep.length;
  const Eigen::Vector2d curve = elastica(sweep.gamma, sweep.stretch).tip();
  Rest rest{segments, (tip - curve).norm()};
  if (!has_an_order(sweep.gamma, segments)) return rest;
  const StrandElastica strands = strand_elastica(sweep.gamma, sweep.stretch, segments);
  rest.expected = strands.error;
  rest.apart = (tip - strands.tip).norm();
  rest.tolerance = strands.tolerance;
  return rest;
}

SegmentSweep sweep_segments(const Material& material, double gamma, const ValidationSettings& settings) {
  SegmentSweep sweep{gamma, length_of(material, gamma), 0, {}};
  sweep.stretch = material.line_density() * kEarthGravity * sweep.length / material.stretch_rigidity();
  for (int segments : {10, 20, 40, 80}) {
    settings.go_on();
    if (settings.quick && segments > 40) break;
    sweep.rests.push_back(find_rest(material, sweep, segments));
  }
  return sweep;
}

// The order between two numbers of segments, one twice the other.
double order(const Rest& coarse, const Rest& fine) {
  return std::log2(coarse.error / fine.error);
}

void check(const SegmentSweep& sweep, std::vector<Check>& checks) {
  const std::string gamma = to_text(sweep.gamma);
  for (std::size_t i = 0; i < sweep.rests.size(); ++i) {
    const Rest& rest = sweep.rests[i];
    if (!has_an_order(sweep.gamma, rest.segments) && std::isfinite(rest.error)) continue;
    const std::string n = std::to_string(rest.segments), id = "gamma" + gamma + "-n" + n;
    checks.push_back(
        {id + "-tip",
         "Gamma = " + gamma + ", " + n + " segments: the tip from the strand's own elastica, over L",
         "the elastica that such a strand follows to fourth order (elastica.h)", 0, rest.apart,
         rest.tolerance, kStrandElasticaTolerance});
    if (i == 0 || !has_an_order(sweep.gamma, sweep.rests[i - 1].segments)) continue;
    checks.push_back({id + "-order", "Gamma = " + gamma + ", " + n + " segments: order of convergence",
                      "central differences, clamped by half a segment", 2, order(sweep.rests[i - 1], rest),
                      1.1 * next_term(sweep.gamma, rest.segments / 2),
                      "the error's next term: 3/4 of it at half as many segments, over log(2)"});
  }
}

Table table_of(const std::vector<SegmentSweep>& sweeps) {
  Table table{
      "Hair at rest: the error of the tip over L, and its order; and how far the tip is from the strand's "
      "own elastica",
      {"Gamma", "length, m", "segments", "error", "expected", "order", "apart"},
      {}};
  for (const SegmentSweep& sweep : sweeps)
    for (std::size_t i = 0; i < sweep.rests.size(); ++i) {
      const Rest& rest = sweep.rests[i];
      const bool ordered = has_an_order(sweep.gamma, rest.segments);
      table.rows.push_back({to_text(sweep.gamma), to_text(sweep.length), std::to_string(rest.segments),
                            printed("%.9g", rest.error),
                            ordered ? printed("%.9g", rest.expected) : "too few segments",
                            i == 0 ? "" : printed("%.4f", order(sweep.rests[i - 1], rest)),
                            ordered ? to_text(rest.apart) : ""});
    }
  return table;
}

Figure figure_of(const std::vector<SegmentSweep>& sweeps) {
  Figure figure{"elastica-error-segments",
                "The elastica: error against segments",
                "Where segments are shorter than the layer at the clamp, n > 1.3 sqrt(Gamma), errors fall by "
                "four when segments are halved; before, hardly.",
                {"segments"},
                {"error of the tip, over L"}};
  for (const SegmentSweep& sweep : sweeps) {
    Series& series = figure.series.emplace_back(Series{"Gamma = " + to_text(sweep.gamma), {}});
    // A logarithmic axis can't show an error that is not above 0.
    for (const Rest& rest : sweep.rests)
      series.points.push_back({static_cast<double>(rest.segments), rest.error,
                               std::to_string(rest.segments) + " segments" +
                                   (has_an_order(sweep.gamma, rest.segments) ? "" : ", too few for an order"),
                               !(rest.error > 0 && std::isfinite(rest.error))});
  }
  figure.guides.push_back({-2, "order 2"});
  return figure;
}

ValidationResult find_rests(const ValidationSettings& settings) {
  const Material hair;
  std::vector<SegmentSweep> sweeps;
  for (const double gamma : {0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5})
    sweeps.push_back(sweep_segments(hair, gamma, settings));
  ValidationResult result;
  for (const SegmentSweep& sweep : sweeps) check(sweep, result.checks);
  result.figures = {figure_of(sweeps)};
  result.tables = {table_of(sweeps)};
  return result;
}

}  // namespace

Validation hair_at_rest() {
  return {"elastica",
          "Hair that is clamped level bends under its own weight like the elastica",
          {"H1", "H2"},
          find_rests};
}

}  // namespace hair
