// STAFF ONLY. H9's figure: a link's strength while it is pulled, let go and pulled again; and a point over a
// strip's triangle.
#include "hair/static_links.h"
#include "reference/figures/drawing.h"

namespace figures {
namespace {

void draw_strength(Drawing& drawing) {
  const hair::StaticLink link = {0, 1, Vector3d::Zero(), 1, 1, 0.5, 1.5};
  const Eigen::Matrix3d frames[] = {Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity()};
  const Plot plot = drawing.plot({60, 60, 290, 220}, {"stretch |*d*| / length", false, 0, 2},
                                 {"strength *s* of a link", false, 0, 1.2}, 5, 5);
  for (const auto& [stretch, word] : {std::pair(link.yields, "yields"), {link.breaks, "breaks"}}) {
    drawing.line({plot(stretch, 0), plot(stretch, 1.2)}, {kMiddle, 1.2, "4 4"});
    drawing.words(plot(stretch, 0) + Spot(5, -8), word, {kQuiet, "start", 14});
  }
  VectorXd largest = VectorXd::Zero(1);
  const auto pull = [&](double from, double to, double aside, int look) {
    const Spots way = sampled(from, to, 60, [&](double stretch) -> Spot {
      hair::remember_stretches({&link, 1}, frames, stretch * VectorXd::Unit(6, 3), largest);
      return plot(stretch, hair::link_strength(link, largest[0])) - Spot(0, aside);
    });
    drawing.line(way, {colour(look), 3});
    drawing.arrow(way[38], way[44], {colour(look), 3});
  };
  pull(0, 1, 0, 0);
  pull(1, 0.1, 3, 1);
  pull(0.1, 1.9, 0, 2);
  drawing.words(plot(0.25, 1.07), "1 pull", {colour(0)});
  drawing.words(plot(0.5, 0.6), "2 let go", {colour(1)});
  drawing.words(plot(1.3, 0.42), "3 pull again", {colour(2), "start"});
}

void draw_contact(Drawing& drawing) {
  VectorXd x(12);
  x << 0, 0, 0, 1.9, 0, 0.2, 0.7, 0, 1.5, 0.95, 0.95, 0.55;
  hair::StripContact contact;
  hair::touch_strip(3, {0, 1, 2}, -1, 1, x, VectorXd::Zero(12), contact);
  const View view = {{410, 310}, 150, {0, 0, 0}, {0.98, 0, -0.05}, {0.12, 0.8, 0.6}};
  const Vector3d corners[] = {x.head<3>(), x.segment<3>(3), x.segment<3>(6)}, point = x.tail<3>();
  const auto& b = contact.shares;
  const Spot foot = view(b[0] * corners[0] + b[1] * corners[1] + b[2] * corners[2]);
  const Spot beside[] = {{-12, 14}, {16, 14}, {0, -12}}, inside[] = {{10, 15}, {11, 7}, {0, 5}};
  for (int i = 0; i < 3; ++i) {
    const Spot corner = view(corners[i]), next = view(corners[(i + 1) % 3]),
               last = view(corners[(i + 2) % 3]);
    drawing.area({next, last, foot}, colour(i), 0.3);
    drawing.line({corner, next}, {kText, 2.5});
    drawing.words((next + last + foot) / 3 + inside[i], "*b*_" + std::to_string(i) + " = " + fixed(b[i], 2),
                  {colour(i), "middle", 14});
    drawing.words(corner + beside[i], "*x*_" + std::to_string(i), {colour(i), "middle", 17});
  }
  drawing.line({view(point), foot}, {kText, 2, "4 3"});
  drawing.arrow(view(point), view(point + 0.45 * contact.normal), {kText, 3}, "*n*", {16, 6});
  drawing.words(0.7 * view(point) + 0.3 * foot + Spot(8, 4), "gap *g*", {kText, "start"});
  drawing.dot(foot);
  drawing.dot(view(point), kText, 7);
  drawing.words(view(point) + Spot(-12, 0), "*x*", {kText, "end", 17});
}

}  // namespace

std::string draw_h9() {
  Drawing drawing("H9", 350, "Does a link recover, and how does a triangle share a push?",
                  "A link's strength while it is pulled, let go and pulled; a point over three areas.");
  draw_strength(drawing);
  draw_contact(drawing);
  return drawing.svg();
}

}  // namespace figures
