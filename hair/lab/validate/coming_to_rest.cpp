// Moving hair comes to rest where all forces balance: clamped level, and standing, below and above the height
// at which it buckles.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "hair/lab/validate/clamped_hair.h"
#include "hair/lab/validate/elastica.h"
#include "hair/lab/validate/greenhill.h"
#include "hair/lab/validate/planar_statics.h"
#include "hair/lab/validate/validations.h"

namespace hair {

namespace {

constexpr double kSettlingStep = 1.0 / 60;  // s

struct Settled {
  Eigen::VectorXd x;  // NaN if the run broke
  double speed = 0;   // m/s, of the fastest particle at the end
};

// Moves hair until drag brings it to rest.
//
// Uses critical drag for an oscillation of `slowest` = w rad/s, so that all faster ones decay at least like
// exp(-w t); runs for 60 / w seconds. H4 and H6 add their own damping, w^2 h for an oscillation w. So the
// slowest one creeps, at the rate w (1 + d - sqrt(2 d + d^2)), d = w h / 2: at w h = 0.5 the rate is half of
// w, and 1e-13 of the initial deviation is left. If there is no slowest oscillation (NaN) the hair is not
// moved, and the run counts as broken.
Settled settle(const StrandStart& start, const Material& material, Method method, double slowest, double step,
               const ValidationSettings& settings) {
  Settled result{Eigen::VectorXd::Constant(start.state.x.size(), std::numeric_limits<double>::quiet_NaN())};
  if (!std::isfinite(slowest)) return result;
  Description description;
  description.strands = {start};
  description.method = method;
  description.step = step;
  description.gravity = Vector3d(0, 0, -kEarthGravity);
  description.drag = 2 * slowest * material.line_density();
  Simulation simulation(std::move(description));
  const particles::State& state = simulation.state(0);
  while (simulation.time() < 60 / slowest) {
    settings.go_on();
    if (simulation.step()) return result;
  }
  result.x = state.x;
  result.speed = state.v.cwiseAbs().maxCoeff();
  return result;
}

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

ValidationResult settle_level(const RestingMethod& known, const ValidationSettings& settings) {
  const Material hair;
  ValidationResult result;
  Table table{"Hair that comes to rest, " + known.name + ", h = 1/60 s",
              {"Gamma", "segments", "from the balance, over L", "from the elastica", "speed left, m/s"},
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
      table.rows.push_back({to_text(gamma), n, to_text(off), printed("%.9g", error), to_text(settled.speed)});
    }
  result.tables = {table};
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
