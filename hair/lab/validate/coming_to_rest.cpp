// Moving hair comes to rest where all forces balance: clamped level, and standing, below and above the height
// at which it buckles.
#include <cmath>
#include <string>
#include <vector>

#include "hair/lab/validate/bending_validations.h"
#include "hair/lab/validate/clamped_hair.h"
#include "hair/lab/validate/greenhill.h"
#include "hair/lab/validate/planar_statics.h"
#include "hair/lab/validate/settle.h"
#include "hair/lab/validate/strand_elastica.h"
#include "solver/study/cpu_time.h"

namespace hair {

namespace {

constexpr double kSettlingStep = 1.0 / 60;  // s

struct RestingMethod {
  Method method;
  std::string id, name;
  std::vector<std::string> exercises;
};

RestingMethod resting_method(Method method) {
  if (method == Method::implicit_euler) return {method, "h4", "H4", {"S1", "H1", "H2", "H4"}};
  return {method, "h6", "H6", {"S1", "H1", "H2", "H4", "H5", "H6"}};
}

double stretch_of(const Material& material, double length) {
  return material.line_density() * kEarthGravity * length / material.stretch_rigidity();
}

// The strand's balance, found from x on, and its slowest oscillation there. NaN if there is no balance.
struct Balanced {
  Eigen::Vector2d tip;  // over its length
  double slowest;       // rad/s
  double rounding;      // the tip's shift by rounding errors of forces, over its length
};

Balanced find_balance(const StrandStart& start, const Eigen::VectorXd& x) {
  const auto strand = under_gravity(start, Vector3d(0, 0, -kEarthGravity));
  const Balance balance = planar_balance(strand->strand, strand->force, x);
  const double length = start.strand.rest_length.sum();
  const double slowest = slowest_frequency(strand->strand, strand->force, balance.x);
  const double stiffness = slowest * slowest * start.strand.mass.minCoeff();
  return {tip_of(balance) / length, slowest, balance.rounding / stiffness / length};
}

double seconds_of_balance(const StrandStart& start) {
  const auto strand = under_gravity(start, Vector3d(0, 0, -kEarthGravity));
  return solver::study::median_seconds({},
                                       [&] { planar_balance(strand->strand, strand->force, start.state.x); });
}

ValidationResult settle_level(const RestingMethod& known, const ValidationSettings& settings) {
  const Material hair;
  ValidationResult result;
  Figure figure{"elastica-" + known.id + "-error-time",
                "The elastica, Gamma = 10: error against time, " + known.name,
                "Straight hair that falls until drag has brought it to rest, h = 1/60 s, timed once, beside "
                "Newton's method, the median of five: the same errors.",
                {"CPU time, s"},
                {"error of the tip, over L"}};
  figure.series = {{known.name + ", 60 / w seconds of motion", {}}, {"Newton's method", {}}};
  Table table{"Hair that comes to rest, " + known.name + ", h = 1/60 s",
              {"Gamma", "segments", "from the balance, over L", "from the elastica", "speed left, m/s"},
              {}};
  Table times{"CPU time of hair that comes to rest, " + known.name + ", h = 1/60 s",
              {"Gamma", "segments", "CPU time, s", "of Newton's method, s: the median of five"},
              {}};
  for (const double gamma : {1.0, 10.0, 100.0})
    for (int segments : {10, 20, 40}) {
      if (segments > (settings.quick ? 10 : gamma == 10 ? 40 : 20)) continue;
      const double length = length_of(hair, gamma), stretch = stretch_of(hair, length);
      const StrandStart start = clamped_hair(hair, segments, length, Vector3d::UnitX());
      const Balanced balanced = find_balance(start, start.state.x);
      const Settled settled = settle(start, hair, known.method, balanced.slowest, kSettlingStep, settings);
      const Eigen::Vector2d tip = planar_tip(settled.x) / length;
      const double off = (tip - balanced.tip).norm(), error = (tip - elastica(gamma, stretch).tip()).norm();
      const std::string n = std::to_string(segments);
      const bool inextensible = known.method == Method::predictor_corrector;
      const double moved = balanced.rounding + (inextensible ? stretch : 0);
      const std::string id = "gamma" + to_text(gamma) + "-n" + n;
      const std::string shows = "Gamma = " + to_text(gamma) + ", " + n + " segments: the tip ";
      const std::string why =
          inextensible ? "W / EA, the stretch that H6 takes away; and what rounding of forces moves the "
                         "slowest swing by"
                       : "what rounding of forces moves the slowest swing by";
      result.checks.push_back({id + "-balance", shows + "from the balance, over L",
                               "the balance of all forces, by Newton's method", 0, off, moved, why});
      if (has_an_order(gamma, segments)) {
        const StrandElastica curve = strand_elastica(gamma, stretch, segments);
        result.checks.push_back({id + "-elastica", shows + "from the strand's own elastica, over L",
                                 "the elastica that such a strand follows to fourth order (elastica.h)", 0,
                                 (tip - curve.tip).norm(), curve.tolerance + moved,
                                 kStrandElasticaTolerance + ("; " + why)});
      }
      const double newton = seconds_of_balance(start);
      table.rows.push_back({to_text(gamma), n, to_text(off), printed("%.9g", error), to_text(settled.speed)});
      times.rows.push_back({to_text(gamma), n, to_text(settled.cpu_seconds), to_text(newton)});
      if (gamma != 10) continue;
      figure.series[0].points.push_back(error_point(settled.cpu_seconds, error, n + " segments"));
      figure.series[1].points.push_back(error_point(newton, error, n + " segments"));
    }
  result.figures = {figure};
  result.tables = {table};
  result.times = {times};
  return result;
}

// An arc of a circle from the clamp on, bent by `angle` in all.
Eigen::VectorXd leaning(const StrandStart& standing, double angle) {
  Eigen::VectorXd x = standing.state.x;
  const int n = standing.strand.segments();
  for (int i = 0; i < n; ++i) {
    const double length = standing.state.x[3 * i + 5] - standing.state.x[3 * i + 2];
    const double theta = angle * (i + 0.5) / n;
    x.segment<3>(3 * i + 3) = x.segment<3>(3 * i) + length * Vector3d(std::sin(theta), 0, std::cos(theta));
  }
  return x;
}

ValidationResult settle_standing(const RestingMethod& known, const ValidationSettings& settings) {
  const Material hair;
  constexpr int kSegments = 10;
  ValidationResult result;
  const double critical = strand_greenhill(kSegments);
  for (const double part : {0.95, 1.05}) {
    const bool stands = part < 1;
    const double length = length_of(hair, part * critical);
    StrandStart start = standing_hair(hair, kSegments, length);
    const Balanced balanced = find_balance(start, stands ? start.state.x : leaning(start, 1));
    start.state.x = leaning(start, 0.5);
    const Settled settled = settle(start, hair, known.method, balanced.slowest, kSettlingStep, settings);
    const double lean = std::abs(planar_tip(settled.x)[0]) / length;
    const double leans = std::abs(balanced.tip[0]);
    // It leans like sqrt(Gamma / critical - 1), and Gamma has the height cubed.
    const double shorter = known.method == Method::predictor_corrector
                               ? 3 * stretch_of(hair, length) / (2 * std::abs(part - 1)) * leans
                               : 0;
    result.checks.push_back(
        {stands ? "below" : "above",
         to_text(part) + " of Greenhill's Gamma, after a push: how far the tip leans, over L",
         stands ? "it stands" : "it falls to where forces balance again", leans, lean,
         balanced.rounding + shorter,
         "what rounding of forces moves the slowest swing by; and, with H6, W / EA of the height"});
  }
  return result;
}

}  // namespace

Validation elastica_in_motion(Method method) {
  const RestingMethod known = resting_method(method);
  return {"elastica-" + known.id,
          "Hair that is clamped level falls, and comes to rest as the elastica, " + known.name,
          known.exercises,
          [known](const ValidationSettings& settings) { return settle_level(known, settings); }};
}

Validation buckling_in_motion(Method method) {
  const RestingMethod known = resting_method(method);
  return {"buckling-" + known.id, "Hair stands below Greenhill's height, and falls above, " + known.name,
          known.exercises,
          [known](const ValidationSettings& settings) { return settle_standing(known, settings); }};
}

}  // namespace hair
