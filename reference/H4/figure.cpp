// STAFF ONLY. H4's figure: a mass turns on a stiff spring for a second, by four methods.
#include <functional>
#include <numbers>

#include "hair/mass_spring/strand_forces.h"
#include "hair/predictor_corrector.h"
#include "particles/implicit_euler.h"
#include "reference/figures/drawing.h"

namespace figures {

namespace {

using Eigen::Vector3d;
using hair::GeometricTerm;
using particles::kSolveTolerance;

constexpr double kLength = 0.3, kStep = 1.0 / 60, kTurn = 2 * std::numbers::pi;

hair::Strand stiff_spring() {
  hair::Strand strand;
  strand.mass = Eigen::Vector2d::Ones();
  strand.rest_length = Eigen::VectorXd::Constant(1, kLength);
  strand.stretch_rigidity = 1e8 * kLength;
  return strand;
}

using Step = std::function<void(const hair::Strand&, const particles::Particles&, particles::State&)>;

Step implicit_step(GeometricTerm term) {
  return [term](const hair::Strand& strand, const particles::Particles& particles, particles::State& state) {
    Eigen::MatrixXd scratch(6, particles::kImplicitScratch);
    particles::implicit_euler(hair::StretchForce(strand, term), particles, kStep, kSolveTolerance, state,
                              scratch);
  };
}

void corrected_step(const hair::Strand& strand, const particles::Particles& particles,
                    particles::State& state) {
  Eigen::MatrixXd scratch(6, hair::kPredictorCorrectorScratch);
  hair::predictor_corrector(hair::StretchForce(strand, GeometricTerm::filtered), particles, strand, kStep,
                            kSolveTolerance, state, scratch);
}

// Backward Euler by Newton's method: x - x_n - h v_n = h^2 f(x) / m.
void converged_step(const hair::Strand& strand, const particles::Particles&, particles::State& state) {
  const hair::StretchForce force(strand, GeometricTerm::full);
  const Eigen::VectorXd before = state.x, free = state.x + kStep * state.v;
  for (int i = 0; i < 50; ++i) {
    Eigen::VectorXd wrong = (free - state.x) / (kStep * kStep);
    Eigen::MatrixXd slope = Eigen::MatrixXd::Identity(6, 6);
    force.add_force(state.x, state.v, wrong);
    for (int k = 0; k < 6; ++k) {
      Eigen::VectorXd change = Eigen::VectorXd::Zero(6);
      force.add_dfdx(state.x, state.v, Eigen::VectorXd::Unit(6, k), change);
      slope.col(k) -= kStep * kStep * change;
    }
    state.x.tail<3>() +=
        kStep * kStep * slope.bottomRightCorner<3, 3>().partialPivLu().solve(wrong.tail<3>());
  }
  state.v = (state.x - before) / kStep;
}

void draw_revolution(Drawing& drawing, double middle, const char* first, const char* second, int look,
                     const Step& step) {
  const hair::Strand strand = stiff_spring();
  const particles::Particles particles{strand.mass, {1, 0}};
  particles::State state{Eigen::VectorXd::Zero(6), Eigen::VectorXd::Zero(6)};
  state.x[3] = kLength;
  state.v[4] = kTurn * kLength;
  const View view = {{middle, 120}, 190};
  drawing.ring(view.middle, view.unit * kLength, {kFaint, 6});
  Spots way = {view(state.x.tail<3>())};
  for (int i = 0; i < 60; ++i) {
    step(strand, particles, state);
    way.push_back(view(state.x.tail<3>()));
  }
  for (const Spot& spot : way) drawing.dot(spot, colour(look), 2.2);
  drawing.line({view.middle, way.back()}, {kText, 1.5});
  drawing.dot(view.middle, kText, 3);
  drawing.ring(way.front(), 6, {kText, 1.5});
  drawing.dot(way.back(), kText, 6);
  const Vector3d v = state.v.tail<3>();
  drawing.arrow(way.back(), view(Vector3d(state.x.tail<3>()) + 0.1 * v), {colour(look), 3});
  drawing.words({middle, 222}, first, {colour(look)});
  drawing.words({middle, 241}, second, {colour(look)});
  const double momentum = Vector3d(state.x.tail<3>()).cross(v)[2] / (kLength * kLength * kTurn);
  drawing.words({middle, 268}, "*L*/*L*_0 = " + fixed(momentum, momentum < 0.1 ? 3 : 2),
                {kText, "middle", 16, "bold"});
}

}  // namespace

std::string draw_H4() {
  Drawing drawing(
      "H4", "After one second, how far has the mass turned, and how fast does it still go?",
      "Four circles with the places of a mass after each of 60 steps. Converged backward Euler gets "
      "most of the way round and keeps 66 percent of its momentum; one linearisation with the full "
      "term stops at once; without the term it keeps all; the predictor-corrector keeps 78 percent.",
      284);
  draw_revolution(drawing, 90, "backward Euler,", "converged", 7, converged_step);
  draw_revolution(drawing, 270, "one linearisation,", "full or filtered term", 1,
                  implicit_step(GeometricTerm::full));
  draw_revolution(drawing, 450, "one linearisation,", "term dropped", 0,
                  implicit_step(GeometricTerm::dropped));
  draw_revolution(drawing, 630, "predictor-corrector", "(H6)", 2, corrected_step);
  return drawing.svg();
}

}  // namespace figures
