// STAFF ONLY. H1's figure: a spring's stiffness across itself.
#include "hair/stretch_springs.h"
#include "reference/figures/drawing.h"

namespace figures {
namespace {

using hair::GeometricTerm;

// The force with which a spring of stiffness 1 and this length resists a move of its end by 1 across.
double resistance(double length, GeometricTerm term) {
  const hair::Strand spring{Eigen::Vector2d::Ones(), VectorXd::Ones(1), 1.0};
  VectorXd df = VectorXd::Zero(6);
  hair::add_stretch_product(spring, length * VectorXd::Unit(6, 3), term, VectorXd::Unit(6, 4), df);
  return -df[4];
}

// A spring whose end is pushed aside, and the force that it answers with.
void draw_spring(Drawing& drawing, double middle, double length, const char* answer) {
  constexpr double kUnit = 88, kAside = 18, kPerUnit = 62;
  const Spot root(middle - kUnit * length / 2, 415), end = root + Spot(kUnit * length, -kAside);
  const Spot along = (end - root) / 12, across = Spot(-along[1], along[0]).normalized();
  drawing.line({root, root + Spot(kUnit * length, 0)}, {kMiddle, 1, "4 4"});
  drawing.line(sampled(0, 12, 24,
                       [&](double i) -> Spot { return root + i * along + 7 * std::sin(i * M_PI) * across; }),
               {kText, 1.5});
  drawing.dot(root, kText, 5);
  drawing.dot(end, kText, 6);
  const double force = resistance(length, GeometricTerm::full);
  drawing.arrow(end, end + Spot(0, kPerUnit * force), {colour(force < 0 ? 1 : 2), 4});
  drawing.words({middle, 450}, answer, {kText, "middle", 14});
}

}  // namespace

std::string draw_h1() {
  Drawing drawing(
      "H1", 466, "How stiff is a spring across itself?",
      "The factor across against length: full, filtered and dropped. Three springs, pushed aside.");
  const Plot plot = drawing.plot({70, 50, 590, 270}, {"*l* / *l*_0", false, 0.4, 2},
                                 {"stiffness across / *k*", false, -1.5, 0.75}, 8, 5);
  drawing.area({plot(0.4, 0), plot(1, 0), plot(1, -1.5), plot(0.4, -1.5)}, colour(1), 0.12);
  const auto draw = [&](GeometricTerm term, const Pen& pen) {
    drawing.line(sampled(0.4, 2, 80, [&](double length) { return plot(length, resistance(length, term)); }),
                 pen);
  };
  draw(GeometricTerm::full, {colour(1), 7, "none", 0.5});
  draw(GeometricTerm::dropped, {colour(7), 2.5, "7 4"});
  draw(GeometricTerm::filtered, {colour(0), 2.5});
  drawing.words(plot(0.66, -0.75), "full: 1 − *l*_0/*l*", {colour(1), "start"});
  drawing.words(plot(1.3, 0.42), "filtered: never below 0", {colour(0), "end"});
  drawing.words(plot(1.98, -0.14), "dropped: 0 everywhere", {colour(7), "end"});
  drawing.words(plot(0.98, -1.2), "below 0 a step's matrix", {kText, "end", 13});
  drawing.words(plot(0.98, -1.36), "may be indefinite", {kText, "end", 13});
  draw_spring(drawing, plot(0.55, 0)[0], 0.55, "pushes on: it buckles");
  draw_spring(drawing, plot(1, 0)[0], 1, "nothing");
  draw_spring(drawing, plot(1.6, 0)[0], 1.6, "pulls back");
  return drawing.svg();
}

}  // namespace figures
