// STAFF ONLY. H7's figure: a link that hangs on its parent by a hinge.
#include "hair/rigid_links.h"
#include "reference/figures/drawing.h"

namespace figures {

namespace {

using Eigen::Vector3d;

void draw_rod(Drawing& drawing, const View& view, const Vector3d& from, const Vector3d& to) {
  drawing.line({view(from), view(to)}, {kMiddle, 17, "none", 0.35});
}

void name(Drawing& drawing, const Spot& at, const char* text, const std::string& hue,
          const char* anchor = "middle") {
  drawing.words(at, text, {hue, anchor, 18});
}

}  // namespace

std::string draw_H7() {
  Drawing drawing(
      "H7", "Which vectors say how a link lies on its parent, and how it moves?",
      "A parent rod and a link, joined by a hinge. r leads from the parent's centre of mass to the "
      "link's, d from the hinge to the link's centre, u is the hinge's axis. The link's angular "
      "velocity is its parent's plus the rate times u; its velocity v starts at its own centre of mass.",
      372);
  const View view = {{160, 215}, 205, {0, 0, 0}, {0.94, 0, 0.34}, {0.12, 0.94, -0.33}};
  hair::Link base, link;
  const Vector3d joint(1, 0.12, 0);
  link.u = Vector3d(0.1, 1, 0.15).normalized();
  link.d = Vector3d(0.72, -0.32, 0.62);
  link.d -= link.u.dot(link.d) * link.u;
  link.r = joint + link.d;
  std::vector<hair::LinkPass> passes(2);
  passes[0].v = {Vector3d(0.55, 0.45, 0), Vector3d(0, 0, -0.15)};
  hair::outward_velocities({base, link}, Eigen::VectorXd::Constant(1, -0.75), passes);
  const Vector3d parent = Vector3d::Zero(), centre = link.r;
  const hair::SpatialMotion& v = passes[1].v;

  draw_rod(drawing, view, -0.55 * joint, joint);
  draw_rod(drawing, view, joint, joint + 1.7 * link.d);
  drawing.words(view(-0.5 * joint) + Spot(0, 34), "the parent", {kQuiet});
  drawing.words(view(joint + 1.5 * link.d) + Spot(-10, 40), "link *i*", {kQuiet, "end"});

  drawing.arrow(view(parent), view(centre), {colour(2), 2.5});
  name(drawing, view(0.5 * centre) + Spot(-6, 30), "*r*", colour(2));
  drawing.arrow(view(joint), view(centre), {colour(0), 3.5});
  name(drawing, view(joint + 0.5 * link.d) + Spot(10, -14), "*d*", colour(0));
  drawing.arrow(view(joint - 0.35 * link.u), view(joint + 0.62 * link.u), {kText, 3});
  name(drawing, view(joint + 0.62 * link.u) + Spot(-12, 0), "*u*", kText, "end");

  drawing.arrow(view(parent), view(parent + passes[0].v.angular), {colour(7), 3});
  name(drawing, view(parent + passes[0].v.angular) + Spot(0, -12), "*ω* of the parent", colour(7));
  drawing.arrow(view(centre), view(centre + passes[0].v.angular), {colour(7), 2, "5 4"});
  drawing.arrow(view(centre + passes[0].v.angular), view(centre + v.angular), {kText, 2, "5 4"});
  name(drawing, view(centre + passes[0].v.angular) + Spot(10, 24), "*q̇ u*", kText, "start");
  drawing.arrow(view(centre), view(centre + v.angular), {colour(7), 3.5});
  name(drawing, view(centre + v.angular) + Spot(12, 8), "*ω*", colour(7), "start");
  drawing.arrow(view(centre), view(centre + 1.7 * v.linear), {colour(1), 3.5});
  name(drawing, view(centre + 1.7 * v.linear) + Spot(-12, 4), "*v*", colour(1), "end");

  drawing.ring(view(joint), 11, {kText, 3});
  drawing.dot(view(parent), kText, 6);
  drawing.dot(view(centre), kText, 6);
  drawing.words({20, 354}, "● a centre of mass   ○ the hinge", {kQuiet, "start", 14});
  return drawing.svg();
}

}  // namespace figures
