// STAFF ONLY. H6's figure: the five steps, of a mass that swings on a stiff segment.
#include "hair/mass_spring/strand_forces.h"
#include "hair/predictor_corrector.h"
#include "particles/force_sum.h"
#include "particles/gravity.h"
#include "reference/figures/drawing.h"

namespace figures {

namespace {

using Eigen::Vector3d, Eigen::VectorXd;

constexpr double kSwing = 0.1;  // s, a step

// A panel: the circle that the length allows, the pin, and the mass where it was and where it is.
class Panel {
 public:
  Panel(Drawing& drawing, int number, const char* name, const char* formula)
      : drawing_(drawing), view_{{144.0 * number - 72, 46}, 128} {
    Spots arc;
    for (int i = -10; i <= 10; ++i)
      arc.push_back(view_(Vector3d(std::sin(0.05 * i), -std::cos(0.05 * i), 0)));
    drawing.line(arc, {kMiddle, 1.5, "5 4"});
    drawing.dot(view_.middle, kMiddle, 5);
    drawing.words({view_.middle[0], 28}, std::to_string(number) + " " + name, {kText, "middle", 15, "bold"});
    drawing.words({view_.middle[0], 236}, formula, {kText, "middle", 16});
  }
  void mass(const VectorXd& x, bool now) {
    drawing_.line({view_.middle, view_(x.tail<3>())}, {now ? kText : kMiddle, now ? 2.5 : 1.5});
    if (now)
      drawing_.dot(view_(x.tail<3>()), kText, 7);
    else
      drawing_.ring(view_(x.tail<3>()), 6, {kMiddle, 1.5});
  }
  void arrow(const VectorXd& from, const VectorXd& to, int look, const char* dash = "none") {
    drawing_.arrow(view_(from.tail<3>()), view_(to.tail<3>()), {colour(look), 3.5, dash});
  }

 private:
  Drawing& drawing_;
  View view_;
};

// Adds the change of velocity of an implicit solve for half a step.
void filter(const particles::Force& force, const particles::Particles& particles, particles::State& state) {
  VectorXd dv(6);
  Eigen::MatrixXd scratch(6, particles::kImplicitScratch);
  particles::solve_implicit(force, particles, state, kSwing / 2, kSwing, particles::kSolveTolerance, dv,
                            scratch);
  state.v += dv;
}

}  // namespace

std::string draw_H6() {
  Drawing drawing(
      "H6", "Which of the five steps moves the mass, and which changes its velocity?",
      "Five panels of a mass on a stiff segment, with the circle on which its length is right. The "
      "filter gives a velocity along the tangent; the mass moves along it, off the circle; the "
      "correction puts it back; the impulse turns the velocity into the chord; the second filter "
      "takes away what points along the segment.",
      256);
  hair::Strand strand;
  strand.mass = Eigen::Vector2d::Ones();
  strand.rest_length = VectorXd::Ones(1);
  strand.stretch_rigidity = 1e8;
  const particles::Particles particles{strand.mass, {1, 0}};
  particles::ForceSum force;
  force.emplace<hair::StretchForce>(strand, hair::GeometricTerm::filtered);
  force.emplace<particles::Gravity>(strand.mass, Vector3d(0, -particles::kEarthGravity, 0));
  particles::State state{VectorXd::Zero(6), VectorXd::Zero(6)};
  state.x.tail<3>() << std::sin(-0.48), -std::cos(0.48), 0;
  state.v.tail<3>() = Vector3d(0, 0, 5.2).cross(Vector3d(state.x.tail<3>()));

  Panel first(drawing, 1, "filter", "*v^{n+½}*");
  const VectorXd start = state.x;
  filter(force, particles, state);
  first.mass(start, true);
  first.arrow(start, start + kSwing * state.v, 0);

  Panel second(drawing, 2, "advance", "*x* + *h v^{n+½}*");
  state.x += kSwing * state.v;
  second.mass(start, false);
  second.arrow(start, state.x, 0);
  second.mass(state.x, true);

  Panel third(drawing, 3, "correct", "+ *x*^{corr}");
  const VectorXd predicted = state.x, tangent = state.v;
  Eigen::MatrixXd scratch(6, hair::kCorrectionScratch);
  hair::correct_lengths(strand, hair::kLengthTolerance, hair::kMostCorrections, state.x, scratch);
  third.mass(predicted, false);
  third.mass(state.x, true);
  third.arrow(predicted, state.x, 1);

  Panel fourth(drawing, 4, "impulse", "+ *x*^{corr}/*h*");
  state.v += (state.x - predicted) / kSwing;
  fourth.mass(start, false);
  fourth.mass(state.x, true);
  fourth.arrow(state.x, state.x + kSwing * state.v, 0);
  fourth.arrow(start, state.x, 0, "3 3");

  Panel fifth(drawing, 5, "filter", "*v^{n+1}*");
  fifth.mass(state.x, true);
  fifth.arrow(state.x, state.x + kSwing * state.v, 6, "3 3");
  filter(force, particles, state);
  fifth.arrow(state.x, state.x + kSwing * state.v, 0);
  return drawing.svg();
}

}  // namespace figures
