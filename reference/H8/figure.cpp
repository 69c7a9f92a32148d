// STAFF ONLY. H8's figure: an element with its frame, and how it moves when one of its numbers grows.
#include "hair/super_helix.h"
#include "reference/figures/drawing.h"

namespace figures {

namespace {

using Eigen::Vector3d;

constexpr double kElement = 1;         // m
const Vector3d kCurvature(4, 1.5, 5);  // 1/m
const hair::MaterialFrame kStart = {Vector3d::Zero(),
                                    Eigen::AngleAxisd(-M_PI / 2, Vector3d::UnitX()).matrix()};

Spots centre_line(const View& view, const Vector3d& curvature) {
  Spots spots;
  for (int i = 0; i <= 60; ++i)
    spots.push_back(view(hair::frame_at(kStart, curvature, kElement * i / 60).position));
  return spots;
}

void draw_frame(Drawing& drawing, const View& view, const hair::MaterialFrame& frame, bool named) {
  const char* const names[] = {"*n*_1", "*n*_2", "*t*"};
  constexpr int kLooks[] = {1, 2, 0};
  for (int i = 0; i < 3; ++i) {
    const Spot from = view(frame.position), to = view(frame.position + 0.2 * frame.axes.col(i));
    drawing.arrow(from, to, {colour(kLooks[i]), 3});
    if (named)
      drawing.words(to + 14 * (to - from).normalized() + Spot(0, 5), names[i],
                    {colour(kLooks[i]), "middle", 17});
  }
}

}  // namespace

std::string draw_H8() {
  Drawing drawing(
      "H8", "How does an element move when one of its three numbers grows by a tenth?",
      "Left: a piece of a helix with the frame n1, n2, t at its start, in the middle and at its end. "
      "Right, three panels: the same piece, and with kappa 1, kappa 2 or tau greater by a tenth; an "
      "arrow shows where the Jacobian puts the end.",
      350);
  const View large = {{70, 320}, 310, {0, 0, 0}, {0.9, 0, 0.43}, {0.1, 0.97, -0.2}};
  drawing.line(centre_line(large, kCurvature), {kText, 5});
  for (const double s : {0.0, 0.5, 1.0})
    draw_frame(drawing, large, hair::frame_at(kStart, kCurvature, s * kElement), true);
  const char* const names[] = {"*κ*_1 + 10 %", "*κ*_2 + 10 %", "*τ* + 10 %"};
  const hair::HelixJacobian jacobian = hair::jacobian_at(kStart, kCurvature, kElement);
  for (int k = 0; k < 3; ++k) {
    View view = large;
    view.middle = {290 + 142.0 * k, 290};
    view.unit = 290;
    Vector3d more = kCurvature;
    more[k] *= 1.1;
    drawing.line(centre_line(view, kCurvature), {kMiddle, 5, "none", 0.5});
    drawing.line(centre_line(view, more), {colour(7), 3});
    const Vector3d end = hair::frame_at(kStart, kCurvature, kElement).position;
    drawing.arrow(view(end), view(end + jacobian.moves.col(k) * 0.1 * kCurvature[k]), {colour(1), 3});
    drawing.words({315 + 142.0 * k, 330}, names[k], {kText, "middle", 17});
  }
  drawing.words({470, 30}, "→ as the Jacobian says", {colour(1)});
  return drawing.svg();
}

}  // namespace figures
