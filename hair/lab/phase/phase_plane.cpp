#include <algorithm>
#include <cmath>
#include <complex>

#include "hair/io/plot/figure.h"
#include "hair/lab/phase/phase_plane.h"
#include "particles/explicit_integrators.h"

namespace hair::phase {

namespace {

constexpr double kShown = 0.8;  // rad and rad/s, from the middle

// The motion without error: rate^2 / 2 = cos(angle) - cos(kBegin).
Series exact() {
  Series series = {"without error", {}, true, false, true, 6};
  constexpr int kCorners = 100;
  for (int i = 0; i <= 2 * kCorners; ++i) {
    const double angle = kBegin * std::cos(M_PI * i / kCorners);
    const double rate = std::sqrt(std::max(0.0, 2 * (std::cos(angle) - std::cos(kBegin))));
    series.points.push_back({angle, i < kCorners ? -rate : rate});
  }
  return series;
}

Row row_of(const Motion& motion) {
  const auto steps = static_cast<double>(motion.states.size() - 1);
  return {{"method", "", motion.method},
          {"evaluations", "", static_cast<double>(motion.evaluations) / steps, {"evaluations a step"}},
          {"should_evaluate", "", motion.should_evaluate, {"should be"}},
          {"energy", "", motion.states.back().energy(), {"energy at the end / at the beginning"}},
          {"should_end", "", motion.should_end, {"of small swings, about"}}};
}

Section section_of(const Motion& motion, int look) {
  std::string id = motion.method;
  std::ranges::replace(id, ' ', '-');
  Figure figure = {id,
                   "Phase plane: " + motion.method,
                   motion.should,
                   {"angle, rad", false, -kShown, kShown},
                   {"rate, rad/s", false, -kShown, kShown}};
  figure.same_unit = true;
  Series way = {"step by step", {}, true, false, false, look};
  for (const State& state : motion.states) {
    const bool finite = std::isfinite(state.angle) && std::isfinite(state.rate);
    way.points.push_back(
        {finite ? state.angle : 0, finite ? state.rate : 0, finite ? "" : "not a number", !finite});
  }
  figure.series = {way, exact(), {"begin", {{kBegin, 0}}, false, true, false, look}};
  return {motion.method, {motion.should}, {to_svg(figure)}};
}

// A particle whose third number is the angle: code that forgets the factor 3 does not move it.
class Pendulum : public particles::Dynamics {
 public:
  void acceleration(particles::Input x, particles::Input, particles::Output a) override {
    ++evaluations;
    a.setZero();
    a[2] = -std::sin(x[2]);
  }
  long evaluations = 0;
};

using Method = void (*)(particles::Dynamics&, double, particles::Output, particles::Output,
                        particles::Scratch);

void play(Method method, Motion& motion) {
  Pendulum pendulum;
  Eigen::VectorXd x = Eigen::Vector3d(0, 0, kBegin), v = Eigen::VectorXd::Zero(3);
  Eigen::MatrixXd scratch = Eigen::MatrixXd::Zero(3, particles::kIntegratorScratch);
  motion.states.push_back({x[2], v[2]});
  for (int step = 0; step < kSteps && std::isfinite(x[2]) && std::isfinite(v[2]); ++step) {
    method(pendulum, kStep, x, v, scratch);
    motion.states.push_back({x[2], v[2]});
  }
  motion.evaluations = pendulum.evaluations;
}

// A method of this order multiplies small swings by the Taylor polynomial of exp(ih) in each step.
double energy_of_small_swings(int order) {
  std::complex<double> factor = 1, term = 1;
  for (int k = 1; k <= order; ++k) {
    term *= std::complex<double>(0, kStep) / static_cast<double>(k);
    factor += term;
  }
  return std::pow(std::abs(factor), 2 * kSteps);
}

}  // namespace

OrderedJson phase_json(const std::vector<Motion>& motions) {
  return {{"format", 1}, {"step", kStep}, {"steps", kSteps}, {"methods", json_of(rows_of(motions, row_of))}};
}

std::vector<Row> phase_rows(const std::vector<Motion>& motions) {
  std::vector<Row> rows;
  for (const Motion& motion : motions)
    for (std::size_t step = 0; step < motion.states.size(); ++step) {
      const State& state = motion.states[step];
      rows.push_back({{"method", "", motion.method},
                      {"time", "s", kStep * static_cast<double>(step)},
                      {"angle", "rad", state.angle},
                      {"rate", "rad/s", state.rate},
                      {"energy", "", state.energy()}});
    }
  return rows;
}

Page phase_page(const std::vector<Motion>& motions) {
  Page page = {"Four methods in the phase plane",
               {"A pendulum swings from " + to_text(kBegin) + " rad, in " + std::to_string(kSteps) +
                " steps of " + to_text(kStep) +
                " s. Angle to the right, rate upwards: a motion without error goes round and round on one "
                "curve, clockwise. All four methods take the same steps."}};
  page.sections.push_back({"Evaluations and energy",
                           {},
                           {},
                           {},
                           {table_of(rows_of(motions, row_of), "What it costs and gains")}});
  for (std::size_t i = 0; i < motions.size(); ++i)
    page.sections.push_back(section_of(motions[i], static_cast<int>(i)));
  return page;
}

double State::energy() const {
  return (rate * rate / 2 + 1 - std::cos(angle)) / (1 - std::cos(kBegin));
}

std::vector<Motion> phase_plane() {
  std::vector<Motion> motions = {
      {"forward Euler", "It winds outwards and leaves the picture: each step gains energy.", 1,
       energy_of_small_swings(1)},
      {"symplectic Euler",
       "It stays on a closed curve, which leans to one side: the energy goes up and down, and is never lost.",
       1},
      {"midpoint", "It winds outwards slowly: the error of a step is of the third order.", 2,
       energy_of_small_swings(2)},
      {"Runge-Kutta 4", "It stays on the exact curve, as far as one can see.", 4, energy_of_small_swings(4)}};
  constexpr Method kMethods[] = {particles::forward_euler, particles::symplectic_euler, particles::midpoint,
                                 particles::runge_kutta_4};
  for (std::size_t i = 0; i < motions.size(); ++i) play(kMethods[i], motions[i]);
  return motions;
}

}  // namespace hair::phase
