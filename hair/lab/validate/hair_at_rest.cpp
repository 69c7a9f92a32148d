// Hair that is clamped level and bends under its own weight, at rest, beside the elastica: the error against
// the number of segments.
#include <cmath>
#include <string>
#include <vector>

#include "hair/lab/validate/clamped_hair.h"
#include "hair/lab/validate/elastica.h"
#include "hair/lab/validate/planar_statics.h"
#include "hair/lab/validate/validations.h"

namespace hair {

namespace {

// True if segments are shorter than the boundary layer at the clamp: only then errors have an order.
bool has_an_order(double gamma, int segments) {
  return segments >= 1.3 * std::sqrt(gamma);
}

// The ratio of the error's second term to its first. In the boundary layer at the clamp, 4 n^2 sinh^2(mu /
// 2n) = Gamma: the strand's decay rate is mu = sqrt(Gamma) (1 - q / 24 + 3 q^2 / 640 - ...), q = Gamma / n^2,
// so that the second term is 9/80 q of the first.
double next_term(double gamma, int segments) {
  return 9.0 / 80 * gamma / (segments * segments);
}

// The tip over L; NaN if no balance was found.
Eigen::Vector2d tip_at_rest(const Material& material, int segments, double length) {
  const StrandStart start = clamped_hair(material, segments, length, Vector3d::UnitX());
  const auto strand = under_gravity(start, Vector3d(0, 0, -kEarthGravity));
  return tip_in_balance(strand->strand, strand->force, start.state.x) / length;
}

// Hair of one length in more and more segments.
void sweep_segments(double gamma, const ValidationSettings& settings, ValidationResult& result) {
  const Material hair;
  const double length = length_of(hair, gamma),
               stretch = hair.line_density() * kEarthGravity * length / hair.stretch_rigidity();
  const Eigen::Vector2d curve = elastica(gamma, stretch).tip;
  Series& series = result.figures[0].series.emplace_back(Series{"Gamma = " + to_text(gamma), {}});
  double before = 0;  // the error with half as many segments
  for (const int segments : {10, 20, 40, 80}) {
    settings.go_on();
    if (settings.quick && segments > 40) break;
    const Eigen::Vector2d tip = tip_at_rest(hair, segments, length);
    const double error = (tip - curve).norm();
    const double order = std::log2(before / error);
    const bool ordered = has_an_order(gamma, segments);
    const std::string n = std::to_string(segments), id = "gamma" + to_text(gamma) + "-n" + n,
                      shows = "Gamma = " + to_text(gamma) + ", " + n + " segments: ";
    // With the fourth-order curve of the strand: the tip's error, and the distance of the two tips. Too few
    // segments have none.
    double expected = 0, apart = 0;
    if (ordered) {
      const Eigen::Vector2d own = elastica(gamma, stretch, segments).tip;
      expected = (own - curve).norm();
      apart = (tip - own).norm();
    }
    if (ordered || !std::isfinite(error)) {
      result.checks.push_back(
          {id + "-tip", shows + "the tip from the strand's own elastica, over L",
           "the elastica that such a strand follows to fourth order (elastica.h)", 0, ordered ? apart : error,
           ordered ? expected * (next_term(gamma, segments) + stretch) + 1e-12 : 0,
           "the error's next term, 9/80 Gamma / n^2 of it, its stretch, and where Newton's method ends"});
      if (segments > 10 && has_an_order(gamma, segments / 2))
        result.checks.push_back({id + "-order", shows + "order of convergence",
                                 "central differences, clamped by half a segment", 2, order,
                                 1.1 * next_term(gamma, segments / 2),
                                 "the error's next term: 3/4 of it at half as many segments, over log(2)"});
    }
    result.tables[0].rows.push_back({to_text(gamma), to_text(length), n, printed("%.9g", error),
                                     ordered ? printed("%.9g", expected) : "too few segments",
                                     segments == 10 ? "" : printed("%.4f", order),
                                     ordered ? to_text(apart) : ""});
    // A logarithmic axis can't show an error that is not above 0.
    series.points.push_back({static_cast<double>(segments), error,
                             n + " segments" + (ordered ? "" : ", too few for an order"),
                             !(error > 0 && std::isfinite(error))});
    before = error;
  }
}

}  // namespace

ValidationResult hair_at_rest(const ValidationSettings& settings) {
  ValidationResult result;
  result.tables = {
      {"Hair at rest: the error of the tip over L, and its order; and how far the tip is from the "
       "strand's own elastica",
       {"Gamma", "length, m", "segments", "error", "expected", "order", "apart"},
       {}}};
  result.figures = {
      {"elastica-error-segments",
       "The elastica: error against segments",
       "Where segments are shorter than the layer at the clamp, n > 1.3 sqrt(Gamma), errors fall "
       "by four when segments are halved; before, hardly.",
       {"segments"},
       {"error of the tip, over L"}}};
  for (const double gamma : {0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5}) sweep_segments(gamma, settings, result);
  result.figures[0].guides.push_back({-2, "order 2"});
  return result;
}

}  // namespace hair
