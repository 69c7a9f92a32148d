// STAFF ONLY. H6's figure: the five steps, of a mass that swings on a stiff segment.
#include "hair/mass_spring/strand_forces.h"
#include "hair/predictor_corrector.h"
#include "particles/force_sum.h"
#include "particles/gravity.h"
#include "reference/figures/drawing.h"

namespace figures {
namespace {

constexpr double kTime = 0.1;  // s, a step

// A panel: the circle that the length allows, the pin, the mass where it is, and where it was.
struct Panel {
  Drawing& drawing;
  View view;

  Panel(Drawing& on, int number, const char* name, const char* formula, const VectorXd& is,
        const VectorXd& was = {})
      : drawing(on), view{{144.0 * number - 72, 46}, 128} {
    const auto arc = [&](double angle) { return view(Vector3d(std::sin(angle), -std::cos(angle), 0)); };
    drawing.line(sampled(-0.5, 0.5, 20, arc), {kMiddle, 1.5, "5 4"});
    drawing.dot(view.middle, kMiddle, 5);
    drawing.words(view.middle - Spot(0, 18), std::to_string(number) + " " + name,
                  {kText, "middle", 15, "bold"});
    drawing.words(view.middle + Spot(0, 190), formula, {kText, "middle", 16});
    if (was.size() > 0) {
      drawing.line({view.middle, view(was.tail<3>())}, {kMiddle, 1.5});
      drawing.ring(view(was.tail<3>()), 6, {kMiddle, 1.5});
    }
    drawing.line({view.middle, view(is.tail<3>())}, {kText, 2.5});
    drawing.dot(view(is.tail<3>()), kText, 7);
  }
  void arrow(const VectorXd& from, const VectorXd& way, int look, const char* dash = "none") {
    drawing.arrow(view(from.tail<3>()), view((from + way).tail<3>()), {colour(look), 3.5, dash});
  }
};

}  // namespace

std::string draw_h6() {
  Drawing drawing("H6", 284, "Which of the five steps moves the mass, and which changes its velocity?",
                  "A mass on a stiff segment, and the circle on which its length is right, after each step.");
  const hair::Strand strand{Eigen::Vector2d::Ones(), VectorXd::Ones(1), 1e8};
  const particles::Particles particles{strand.mass, {1, 0}};
  particles::ForceSum force;
  force.emplace<hair::StretchForce>(strand, hair::GeometricTerm::filtered);
  force.emplace<particles::Gravity>(strand.mass, Vector3d(0, -particles::kEarthGravity, 0));
  particles::State state{VectorXd::Zero(6), VectorXd::Zero(6)};
  state.x.tail<3>() << std::sin(-0.48), -std::cos(0.48), 0;
  state.v.tail<3>() = Vector3d(0, 0, 5.2).cross(Vector3d(state.x.tail<3>())) + 1.5 * state.x.tail<3>();
  Eigen::MatrixXd scratch(6, particles::kImplicitScratch + hair::kCorrectionScratch);
  const auto filter = [&] {
    VectorXd dv(6);
    particles::solve_implicit(force, particles, state, kTime / 2, kTime, particles::kSolveTolerance, dv,
                              scratch);
    state.v += dv;
  };

  const VectorXd start = state.x;
  Panel first(drawing, 1, "filter", "*v^{n+½}*", start);
  first.arrow(start, kTime * state.v, 6, "3 3");
  filter();
  first.arrow(start, kTime * state.v, 0);
  const VectorXd predicted = state.x += kTime * state.v;
  Panel(drawing, 2, "advance", "*x* + *h v^{n+½}*", predicted, start).arrow(start, kTime * state.v, 0);
  hair::correct_lengths(strand, hair::kLengthTolerance, hair::kMostCorrections, state.x, scratch);
  const VectorXd corrected = state.x - predicted;
  Panel(drawing, 3, "correct", "+ *x*^{corr}", state.x, predicted).arrow(predicted, corrected, 1);
  state.v += corrected / kTime;
  Panel impulse(drawing, 4, "impulse", "+ *x*^{corr}/*h*", state.x, start);
  impulse.arrow(state.x, kTime * state.v, 0);
  impulse.arrow(start, state.x - start, 0, "3 3");
  Panel last(drawing, 5, "filter", "*v^{n+1}*", state.x);
  last.arrow(state.x, kTime * state.v, 6, "3 3");
  filter();
  last.arrow(state.x, kTime * state.v, 0);
  drawing.words({360, 268}, "dotted: in 1 and 5 the velocity before, in 4 the way of the step",
                {kQuiet, "middle", 14});
  return drawing.svg();
}

}  // namespace figures
