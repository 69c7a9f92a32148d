// STAFF ONLY. H8's figure: an element with its frame, and how it moves when one of its numbers grows.
#include "hair/super_helix.h"
#include "reference/figures/drawing.h"

namespace figures {

std::string draw_h8() {
  Drawing drawing("H8", 350, "How does an element move when one of its three numbers grows by 30 %?",
                  "An element with three frames; the same with each number grown, and the Jacobian's arrow.");
  const Vector3d curvature(4, 2.5, 5);  // 1/m, of an element of 1 m
  const hair::MaterialFrame start = {{0, 0, 0}, Eigen::AngleAxisd(-M_PI / 2, Vector3d::UnitX()).matrix()};
  View view = {{70, 320}, 310, {0, 0, 0}, {0.9, 0, 0.43}, {0.1, 0.97, -0.2}};
  const auto draw = [&](const Vector3d& its, const Pen& pen) {
    drawing.line(sampled(0, 1, 60, [&](double s) { return view(hair::frame_at(start, its, s).position); }),
                 pen);
  };
  draw(curvature, {kText, 5});
  for (const double s : {0.0, 0.5, 1.0}) {
    const hair::MaterialFrame frame = hair::frame_at(start, curvature, s);
    for (const auto& [axis, name, look] : {std::tuple(0, "*n*_1", 1), {1, "*n*_2", 2}, {2, "*t*", 0}}) {
      const Spot from = view(frame.position), to = view(frame.position + 0.2 * frame.axes.col(axis));
      drawing.arrow(from, to, {colour(look), 3}, name, 14 * (to - from).normalized() + Spot(0, 5));
    }
  }
  const hair::HelixJacobian jacobian = hair::jacobian_at(start, curvature, 1);
  view.unit = 290;
  for (const auto& [k, name] : {std::pair(0, "*κ*_1 + 30 %"), {1, "*κ*_2 + 30 %"}, {2, "*τ* + 30 %"}}) {
    view.middle = {290 + 142.0 * k, 290};
    const Vector3d more = 0.3 * curvature[k] * Vector3d::Unit(k);
    draw(curvature, {kMiddle, 5, "none", 0.5});
    draw(curvature + more, {colour(7), 3});
    const Vector3d end = hair::frame_at(start, curvature, 1).position;
    drawing.arrow(view(end), view(end + jacobian.moves * more), {kText, 2});
    drawing.words(view.middle + Spot(25, 40), name, {colour(7), "middle", 17});
  }
  drawing.words({470, 30}, "→ as the Jacobian says", {kText});
  return drawing.svg();
}

}  // namespace figures
