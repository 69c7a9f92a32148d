// STAFF ONLY. H4's figure: a mass turns on a stiff spring for a second, by four methods.
#include <functional>
#include <numbers>

#include "hair/mass_spring/strand_forces.h"
#include "hair/predictor_corrector.h"
#include "particles/implicit_euler.h"
#include "reference/figures/drawing.h"

namespace figures {
namespace {

using hair::GeometricTerm, particles::kSolveTolerance;

constexpr double kLength = 0.3, kStep = 1.0 / 60, kTurn = 2 * std::numbers::pi;

// Backward Euler by Newton's method: x - x_n - h v_n = h^2 f(x) for a mass of 1.
void converged_step(const particles::Force& force, particles::State& state) {
  const VectorXd before = state.x, free = state.x + kStep * state.v;
  for (int i = 0; i < 50; ++i) {
    VectorXd wrong = (free - state.x) / (kStep * kStep);
    force.add_force(state.x, state.v, wrong);
    Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(6, 6);
    for (int k = 0; k < 6; ++k) force.add_dfdx(state.x, state.v, VectorXd::Unit(6, k), slope.col(k));
    slope = Eigen::MatrixXd::Identity(6, 6) / (kStep * kStep) - slope;
    state.x.tail<3>() += slope.bottomRightCorner<3, 3>().partialPivLu().solve(wrong.tail<3>());
  }
  state.v = (state.x - before) / kStep;
}

void draw_revolution(Drawing& drawing, double middle, const char* first, const char* second, int look,
                     const std::function<void(particles::State&)>& step) {
  particles::State state{kLength * VectorXd::Unit(6, 3), kTurn * kLength * VectorXd::Unit(6, 4)};
  const View view = {{middle, 120}, 190};
  drawing.ring(view.middle, view.unit * kLength, {kFaint, 6});
  Spots way = {view(state.x.tail<3>())};
  for (int i = 0; i < 60; ++i) {
    step(state);
    way.push_back(view(state.x.tail<3>()));
  }
  for (const Spot& spot : way) drawing.dot(spot, colour(look), 2.2);
  drawing.line({view.middle, way.back()}, {kText, 1.5});
  drawing.dot(view.middle, kText, 3);
  drawing.ring(way.front(), 6, {kText, 1.5});
  drawing.dot(way.back(), kText, 6);
  const Vector3d x = state.x.tail<3>(), v = state.v.tail<3>();
  drawing.arrow(way.back(), view(x + 0.1 * v), {colour(look), 3});
  drawing.words({middle, 222}, first, {colour(look)});
  drawing.words({middle, 241}, second, {colour(look)});
  const double momentum = x.cross(v)[2] / (kLength * kLength * kTurn);
  drawing.words({middle, 268}, "*L*/*L*_0 = " + fixed(momentum, momentum < 0.1 ? 3 : 2),
                {kText, "middle", 16, "bold"});
}

}  // namespace

std::string draw_h4() {
  Drawing drawing("H4", 284, "What is left of a revolution after a second?",
                  "A mass on four circles after each of 60 steps, its velocity and momentum at the end.");
  const hair::Strand strand{Eigen::Vector2d::Ones(), VectorXd::Constant(1, kLength), 1e8 * kLength};
  const particles::Particles particles{strand.mass, {1, 0}};
  const hair::StretchForce full(strand, GeometricTerm::full), filtered(strand, GeometricTerm::filtered),
      dropped(strand, GeometricTerm::dropped);
  Eigen::MatrixXd scratch(6, hair::kPredictorCorrectorScratch);
  draw_revolution(drawing, 90, "backward Euler,", "converged", 7,
                  [&](particles::State& state) { converged_step(full, state); });
  draw_revolution(drawing, 270, "one linearisation,", "full or filtered term", 1,
                  [&](particles::State& state) {
                    particles::implicit_euler(full, particles, kStep, kSolveTolerance, state, scratch);
                  });
  draw_revolution(drawing, 450, "one linearisation,", "term dropped", 0, [&](particles::State& state) {
    particles::implicit_euler(dropped, particles, kStep, kSolveTolerance, state, scratch);
  });
  draw_revolution(drawing, 630, "predictor-corrector", "(H6)", 2, [&](particles::State& state) {
    hair::predictor_corrector(filtered, particles, strand, kStep, kSolveTolerance, state, scratch);
  });
  return drawing.svg();
}

}  // namespace figures
