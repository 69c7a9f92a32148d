// STAFF ONLY. H1's figure: a spring's stiffness across itself.
#include "hair/stretch_springs.h"
#include "reference/figures/drawing.h"

namespace figures {

namespace {

hair::Strand one_spring() {
  hair::Strand strand;
  strand.mass = Eigen::Vector2d::Ones();
  strand.rest_length = Eigen::VectorXd::Ones(1);
  strand.stretch_rigidity = 1;
  return strand;
}

// The force with which a spring of stiffness 1 and this length resists a move of its end by 1 across.
double resistance(double length, hair::GeometricTerm term) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(6), dx = x, df = x;
  x[3] = length;
  dx[4] = 1;
  hair::add_stretch_product(one_spring(), x, term, dx, df);
  return -df[4];
}

// A spring between two walls' distances, its end pushed aside, and the force that it answers with.
void draw_spring(Drawing& drawing, double middle, double length) {
  constexpr double kUnit = 88, kAside = 18, kPerUnit = 62;
  const Spot root(middle - kUnit * length / 2, 415), end = root + Spot(kUnit * length, -kAside);
  Spots zigzag = {root};
  const Spot along = (end - root) / 12, across = Spot(-along[1], along[0]).normalized();
  for (int i = 1; i < 12; ++i) zigzag.emplace_back(root + i * along + (i % 2 == 0 ? 7 : -7) * across);
  zigzag.push_back(end);
  drawing.line({root, root + Spot(kUnit * length, 0)}, {kMiddle, 1, "4 4"});
  drawing.line(zigzag, {kText, 1.5});
  drawing.dot(root, kText, 5);
  drawing.dot(end, kText, 6);
  const double force = resistance(length, hair::GeometricTerm::full);
  drawing.arrow(end, end + Spot(0, kPerUnit * force), {colour(force < 0 ? 1 : 2), 4});
  drawing.words({middle, 450},
                force < 0   ? "pushes on: it buckles"
                : force > 0 ? "pulls back"
                            : "nothing",
                {kText, "middle", 14});
}

}  // namespace

std::string draw_H1() {
  using enum hair::GeometricTerm;
  Drawing drawing(
      "H1", "How stiff is a spring across itself?",
      "The factor across the spring against l over l0. Full rises from far below 0 through 0 at the "
      "rest length; filtered is 0 for a compressed spring and equal to full for a stretched one; "
      "dropped is 0 everywhere. Below, a compressed spring pushes its end further aside, a stretched "
      "one pulls it back.",
      466);
  const Box box = {70, 50, 590, 270};
  const Plot plot =
      drawing.plot(box, {"*l* / *l*_0", false, 0.4, 2}, {"stiffness across / *k*", false, -1.5, 0.75}, 8, 5);
  drawing.area({plot(0.4, 0), plot(1, 0), plot(1, -1.5), plot(0.4, -1.5)}, colour(1), 0.12);
  Spots full_, filtered_, dropped_;
  for (double length = 0.4; length < 2.005; length += 0.02) {
    full_.emplace_back(length, resistance(length, full));
    filtered_.emplace_back(length, resistance(length, filtered));
    dropped_.emplace_back(length, resistance(length, dropped));
  }
  drawing.curve(plot, full_, {colour(1), 7, "none", 0.5});
  drawing.curve(plot, dropped_, {colour(7), 2.5, "7 4"});
  drawing.curve(plot, filtered_, {colour(0), 2.5});
  drawing.words(plot(0.66, -0.75), "full: 1 − *l*_0/*l*", {colour(1), "start"});
  drawing.words(plot(1.3, 0.42), "filtered: never below 0", {colour(0), "end"});
  drawing.words(plot(1.98, -0.12), "dropped: 0", {colour(7), "end"});
  drawing.words(plot(0.98, -1.2), "below 0 a step's matrix", {kText, "end", 13});
  drawing.words(plot(0.98, -1.36), "may be indefinite", {kText, "end", 13});
  for (const double length : {0.55, 1.0, 1.6}) draw_spring(drawing, plot(length, 0)[0], length);
  return drawing.svg();
}

}  // namespace figures
