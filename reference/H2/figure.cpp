// STAFF ONLY. H2's figure: a joint with its forces, and how much the bend wants to leave its plane.
#include <Eigen/Dense>

#include "hair/angular_springs.h"
#include "hair/strand/make_strand.h"
#include "hair/stretch_springs.h"
#include "reference/figures/drawing.h"

namespace figures {
namespace {

Vector3d on_circle(double angle) {
  return {std::cos(angle), std::sin(angle), 0};
}

// Particles 1 apart on an arc, each joint bent by the angle.
VectorXd arc(int segments, double angle) {
  VectorXd x = VectorXd::Zero(3 * segments + 3);
  for (int i = 1; i <= segments; ++i)
    x.segment<3>(3 * i) = x.segment<3>(3 * i - 3) + on_circle((i - 0.5) * angle);
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
  const VectorXd x = arc(2, 1.0);
  VectorXd f = VectorXd::Zero(9);
  hair::add_bend_force(hair::uniform_strand({}, 2, 2), x, f);
  f *= 0.55 / f.segment<3>(3).norm();
  const View view = {{60, 290}, 150, {0, 0, 0}, on_circle(0.3), on_circle(0.3 + M_PI / 2)};
  const Vector3d root = x.head<3>(), joint = x.segment<3>(3), tip = x.tail<3>();
  drawing.line({view(joint), view(joint + 0.75 * (joint - root))}, {kMiddle, 1.2, "5 4"});
  drawing.line(sampled(0.5, 1.5, 20, [&](double angle) { return view(joint + 0.5 * on_circle(angle)); }),
               {kText, 1.5});
  drawing.words(view(joint + 0.7 * on_circle(0.95)), "*φ*", {kText, "middle", 18});
  drawing.arrow(view(root), view(joint), {kText, 4}, "*e*_1", {-74, 36});
  drawing.arrow(view(joint), view(tip), {kText, 4}, "*e*_2", {-40, 36});
  for (int i = 0; i < 9; i += 3) {
    const Vector3d from = x.segment<3>(i), force = f.segment<3>(i);
    drawing.arrow(view(from), view(from + force), {colour(1), 4});
    drawing.dot(view(from), kText, 6);
  }
  drawing.ring(view(joint) + Spot(34, 30), 9, {colour(7), 2});
  drawing.dot(view(joint) + Spot(34, 30), colour(7), 3);
  drawing.words(view(joint) + Spot(50, 36), "*b*, out of the page", {colour(7), "start"});
  drawing.words({30, 40}, "The forces: three, of sum 0.", {colour(1), "start"});
}

}  // namespace

std::string draw_h2() {
  Drawing drawing("H2", 400, "Which forces unbend a joint, and when is an implicit step in danger?",
                  "A joint with three forces; its stiffness out of the plane, below 0, against the angle.");
  draw_joint(drawing);
  const Plot plot =
      drawing.plot({420, 60, 270, 280}, {"angle *φ* of each joint, degrees", false, 0, 90},
                   {"out of the plane: −*φ* tan(*φ*/2), in *EI*/*l*^3", false, -1.6, 0.2}, 5, 5);
  constexpr double kDegree = M_PI / 180;
  drawing.line(
      sampled(1, 90, 60, [&](double angle) { return plot(angle, stiffness_out_of_plane(angle * kDegree)); }),
      {colour(0), 3});
  drawing.words(plot(27, -1.22), "indefinite, hair of", {colour(1), "start", 14});
  for (const auto& [segments, label] : {std::pair(3, -1.37), {30, -1.52}}) {
    const double angle = breaks_at(segments, 1.0 / 60) / kDegree;
    drawing.line({plot(angle, 0.2), plot(angle, -1.6)}, {colour(1), 2, "6 4"});
    drawing.words(plot(27, label),
                  std::to_string(segments) + " segments: from " + fixed(std::ceil(angle), 0) + "°",
                  {colour(1), "start", 14});
  }
  return drawing.svg();
}

}  // namespace figures
