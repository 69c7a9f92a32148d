// STAFF ONLY. H7's figure: a link that hangs on its parent by a hinge.
#include "hair/rigid_links.h"
#include "reference/figures/drawing.h"

namespace figures {

std::string draw_h7() {
  Drawing drawing("H7", 372, "Which vectors say how a link lies on its parent, and how it moves?",
                  "A parent and a link, joined by a hinge, with r, d, u, the angular velocities and v.");
  const View view = {{160, 215}, 205, {0, 0, 0}, {0.94, 0, 0.34}, {0.12, 0.94, -0.33}};
  hair::Link base, link;
  const Vector3d joint(1, 0.3, 0), parent = Vector3d::Zero();
  link.u = Vector3d(0.1, 1, 0.15).normalized();
  link.d = Vector3d(0.72, -0.32, 0.62);
  link.d -= link.u.dot(link.d) * link.u;
  link.r = joint + link.d;
  std::vector<hair::LinkPass> passes(2);
  passes[0].v = {Vector3d(0.55, 0.45, 0), Vector3d(0, 0, -0.15)};
  hair::outward_velocities({base, link}, VectorXd::Constant(1, -0.75), passes);
  const hair::SpatialMotion& v = passes[1].v;
  const Vector3d centre = link.r, carried = centre + passes[0].v.angular, turning = centre + v.angular;

  const Pen rod = {kMiddle, 17, "none", 0.35};
  drawing.line({view(-0.55 * joint), view(joint)}, rod);
  drawing.line({view(joint), view(joint + 1.7 * link.d)}, rod);
  drawing.words(view(-0.5 * joint) + Spot(0, 34), "the parent", {kQuiet});
  drawing.words(view(joint + 1.5 * link.d) + Spot(-10, 40), "link *i*", {kQuiet, "end"});
  drawing.arrow(view(parent), view(centre), {colour(2), 2.5}, "*r*", {-190, 26});
  drawing.arrow(view(joint), view(centre), {colour(0), 3.5}, "*d*", {-80, -42});
  drawing.arrow(view(joint - 0.35 * link.u), view(joint + 0.62 * link.u), {kText, 3}, "*u*", {-16, 0});
  drawing.arrow(view(parent), view(passes[0].v.angular), {colour(7), 3}, "*ω* of the parent", {0, -12});
  drawing.arrow(view(centre), view(carried), {colour(7), 2, "5 4"});
  drawing.arrow(view(carried), view(turning), {kText, 2, "5 4"}, "*q̇ u*, *q̇* < 0", {0, -152});
  drawing.arrow(view(centre), view(turning), {colour(7), 3.5}, "*ω*", {18, 8});
  drawing.arrow(view(centre), view(centre + 1.7 * v.linear), {colour(1), 3.5}, "*v*", {-14, 4});
  drawing.ring(view(joint), 11, {kText, 3});
  drawing.dot(view(parent), kText, 6);
  drawing.dot(view(centre), kText, 6);
  drawing.words({20, 354}, "● a centre of mass   ○ the hinge", {kQuiet, "start", 14});
  return drawing.svg();
}

}  // namespace figures
