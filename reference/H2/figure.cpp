// STAFF ONLY. H2's figure: a joint with its forces, and how much the bend wants to leave its plane.
#include <Eigen/Dense>

#include "hair/angular_springs.h"
#include "hair/strand/make_strand.h"
#include "hair/stretch_springs.h"
#include "reference/figures/drawing.h"

namespace figures {

namespace {

using Eigen::Vector3d, Eigen::VectorXd;

// Particles 1 apart on an arc in the plane of x and y, each joint bent by the angle.
VectorXd arc(int segments, double angle) {
  VectorXd x = VectorXd::Zero(3 * segments + 3);
  for (int i = 1; i <= segments; ++i)
    x.segment<3>(3 * i) =
        x.segment<3>(3 * i - 3) + Vector3d(std::cos((i - 0.5) * angle), std::sin((i - 0.5) * angle), 0);
  return x;
}

// The second derivative of a joint's energy along a move of its ends out of the plane, one to each side,
// times l^3 / EI.
double stiffness_out_of_plane(double angle) {
  const hair::Strand strand = hair::uniform_strand({}, 2, 2);
  const VectorXd dx = (VectorXd::Unit(9, 2) - VectorXd::Unit(9, 8)) / std::sqrt(2);
  VectorXd df = VectorXd::Zero(9);
  hair::add_bend_product(strand, arc(2, angle), dx, df);
  return -dx.dot(df) / strand.bend_rigidity;
}

// The least angle of all joints with which M - h^2 df/dx is indefinite: human hair in segments of 1 cm.
double breaks_at(int segments, double h) {
  constexpr double kSegment = 0.01;
  const hair::Strand strand = hair::uniform_strand({}, segments, segments * kSegment);
  const int n = 3 * segments + 3;
  double low = 0, high = 1.5;
  while (high - low > 1e-4) {
    const double angle = (low + high) / 2;
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
    const VectorXd x = kSegment * arc(segments, angle);
    for (int i = 0; i < n; ++i) {
      hair::add_stretch_product(strand, x, hair::GeometricTerm::filtered, VectorXd::Unit(n, i), A.col(i));
      hair::add_bend_product(strand, x, VectorXd::Unit(n, i), A.col(i));
    }
    A *= -h * h;
    for (int i = 0; i < n; ++i) A(i, i) += strand.mass[i / 3];
    const Eigen::MatrixXd free = A.bottomRightCorner(n - 3, n - 3);  // the root is held
    (free.llt().info() == Eigen::Success ? low : high) = angle;
  }
  return low;
}

void draw_joint(Drawing& drawing) {
  const hair::Strand strand = hair::uniform_strand({}, 2, 2);
  const VectorXd x = arc(2, 1.0);
  VectorXd f = VectorXd::Zero(9);
  hair::add_bend_force(strand, x, f);
  f /= f.segment<3>(3).norm();
  const View view = {
      {60, 290}, 150, {0, 0, 0}, {std::cos(0.3), std::sin(0.3), 0}, {-std::sin(0.3), std::cos(0.3), 0}};
  const auto at = [&](int i) { return Vector3d(x.segment<3>(3 * i)); };
  const Vector3d e1 = at(1) - at(0), e2 = at(2) - at(1);
  drawing.line({view(at(1)), view(at(1) + 0.75 * e1)}, {kMiddle, 1.2, "5 4"});
  Spots bend;
  for (int i = 0; i <= 20; ++i)
    bend.push_back(view(at(1) + 0.5 * Vector3d(std::cos(0.5 + i / 20.0), std::sin(0.5 + i / 20.0), 0)));
  drawing.line(bend, {kText, 1.5});
  drawing.words(view(at(1) + 0.68 * Vector3d(std::cos(0.95), std::sin(0.95), 0)) + Spot(0, 5), "*φ*",
                {kText, "middle", 18});
  drawing.arrow(view(at(0)), view(at(1)), {kText, 4});
  drawing.arrow(view(at(1)), view(at(2)), {kText, 4});
  for (int i = 0; i < 3; ++i) {
    drawing.arrow(view(at(i)), view(at(i) + 0.55 * f.segment<3>(3 * i)), {colour(1), 4});
    drawing.dot(view(at(i)), kText, 6);
  }
  drawing.words(view(at(0) + 0.5 * e1) + Spot(-4, 30), "*e*_1", {kText, "middle", 18});
  drawing.words(view(at(1) + 0.75 * e2) + Spot(-28, -4), "*e*_2", {kText, "middle", 18});
  drawing.ring(view(at(1)) + Spot(34, 30), 9, {colour(7), 2});
  drawing.dot(view(at(1)) + Spot(34, 30), colour(7), 3);
  drawing.words(view(at(1)) + Spot(50, 36), "*b*, out of the page", {colour(7), "start"});
  drawing.words({30, 40}, "The forces: three, of sum 0.", {colour(1), "start"});
}

}  // namespace

std::string draw_H2() {
  Drawing drawing(
      "H2", "Which forces unbend a joint, and when is an implicit step in danger?",
      "Left: two segments e1 and e2 with the angle between them, the axis b out of the page, and three "
      "forces, one a particle, that unbend the joint and cancel. Right: phi times tan of phi / 2 "
      "against the angle; hair of three segments has an indefinite matrix from 20 degrees on, of "
      "thirty from 26.",
      400);
  draw_joint(drawing);
  const Plot plot = drawing.plot({420, 60, 270, 280}, {"angle *φ* of each joint, degrees", false, 0, 90},
                                 {"stiffness out of the plane, × *l*^3/*EI*", false, -1.6, 0.2}, 5, 5);
  Spots values;
  for (double angle = 0.01; angle < M_PI / 2; angle += 0.02)
    values.emplace_back(angle * 180 / M_PI, stiffness_out_of_plane(angle));
  drawing.curve(plot, values, {colour(0), 3});
  drawing.words(plot(26, -1.05) + Spot(6, 0), "indefinite, hair of", {colour(1), "start", 14});
  for (const int segments : {3, 30}) {
    const double angle = breaks_at(segments, 1.0 / 60) * 180 / M_PI;
    drawing.line({plot(angle, 0.2), plot(angle, -1.6)}, {colour(1), 2, "6 4"});
    drawing.words(plot(26, segments == 3 ? -1.2 : -1.35) + Spot(6, 0),
                  std::to_string(segments) + " segments: from " + fixed(std::ceil(angle), 0) + "°",
                  {colour(1), "start", 14});
  }
  return drawing.svg();
}

}  // namespace figures
