// STAFF ONLY. H9's figure: a link's strength while it is pulled, let go and pulled again; and a point over a
// strip's triangle.
#include "hair/static_links.h"
#include "reference/figures/drawing.h"

namespace figures {

namespace {

using Eigen::Vector3d, Eigen::VectorXd;

// The strength at each stretch on the way from one to the other.
Spots pulled(const hair::StaticLink& link, double from, double to, VectorXd& largest) {
  const Eigen::Matrix3d frames[] = {Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity()};
  Spots way;
  for (int i = 0; i <= 60; ++i) {
    const double stretch = from + (to - from) * i / 60;
    VectorXd x = VectorXd::Zero(6);
    x[3] = stretch * link.length;
    hair::remember_stretches({&link, 1}, frames, x, largest);
    way.emplace_back(stretch, hair::link_strength(link, largest[0]));
  }
  return way;
}

void draw_strength(Drawing& drawing) {
  const hair::StaticLink link = {0, 1, Vector3d::Zero(), 1, 1, 0.5, 1.5};
  const Plot plot = drawing.plot({60, 60, 290, 220}, {"stretch |*d*| / length", false, 0, 2},
                                 {"strength *s* of a link", false, 0, 1.2}, 5, 5);
  VectorXd largest = VectorXd::Zero(1);
  const struct {
    double from, to, aside;
    int look;
    const char* name;
    Spot label;
  } ways[] = {{0, 1, 0, 0, "1 pull", {0.25, 1.07}},
              {1, 0.1, 7, 1, "2 let go", {0.5, 0.6}},
              {0.1, 1.9, 0, 2, "3 pull again", {1.3, 0.42}}};
  for (const auto& [from, to, aside, look, name, label] : ways) {
    Spots way;
    for (const Spot& value : pulled(link, from, to, largest)) way.push_back(plot(value) - Spot(0, aside));
    drawing.line(way, {colour(look), 3});
    const std::size_t tip = way.size() * 3 / 5;
    drawing.arrow(way[tip - 3], way[tip], {colour(look), 3});
    drawing.words(plot(label), name, {colour(look), look == 2 ? "start" : "middle"});
  }
  for (const auto& [stretch, word] : {std::pair{link.yields, "yields"}, {link.breaks, "breaks"}}) {
    drawing.line({plot(stretch, 0), plot(stretch, 1.2)}, {kMiddle, 1.2, "4 4"});
    drawing.words(plot(stretch, 0) + Spot(5, -8), word, {kQuiet, "start", 14});
  }
}

void draw_contact(Drawing& drawing) {
  VectorXd x(12), tangents = VectorXd::Zero(12);
  x << 0, 0, 0, 1.9, 0, 0.2, 0.7, 0, 1.5, 0.95, 0.95, 0.55;
  hair::StripContact contact;
  hair::touch_strip(3, {0, 1, 2}, -1, 1, x, tangents, contact);
  const View view = {{410, 310}, 150, {0, 0, 0}, {0.98, 0, -0.05}, {0.12, 0.8, 0.6}};
  const auto corner = [&](int i) { return Vector3d(x.segment<3>(3 * i)); };
  Vector3d foot = Vector3d::Zero();
  for (int i = 0; i < 3; ++i) foot += contact.shares[i] * corner(i);
  constexpr int kLooks[] = {0, 1, 2};
  for (int i = 0; i < 3; ++i) {
    const Vector3d next = corner((i + 1) % 3), last = corner((i + 2) % 3);
    drawing.area({view(next), view(last), view(foot)}, colour(kLooks[i]), 0.3);
    drawing.words(view((next + last + foot) / 3) + Spot(i == 2 ? 0 : 18, 5),
                  "*b*_" + std::to_string(i) + " = " + fixed(contact.shares[i], 2),
                  {colour(kLooks[i]), "middle", 14});
    drawing.words(view(corner(i)) + Spot(i == 1   ? 16
                                         : i == 0 ? -12
                                                  : 0,
                                         i == 2 ? -12 : 14),
                  "*x*_" + std::to_string(i), {colour(kLooks[i]), "middle", 17});
  }
  drawing.line({view(corner(0)), view(corner(1)), view(corner(2)), view(corner(0))}, {kText, 2.5});
  drawing.line({view(corner(3)), view(foot)}, {kText, 2, "4 3"});
  drawing.arrow(view(corner(3)), view(corner(3) + 0.45 * contact.normal), {kText, 3});
  drawing.words(view(corner(3) + 0.45 * contact.normal) + Spot(12, 6), "*n*", {kText, "start", 17});
  drawing.words(view(0.7 * corner(3) + 0.3 * foot) + Spot(8, 4), "gap *g*", {kText, "start"});
  drawing.dot(view(foot), kText, 4);
  drawing.dot(view(corner(3)), kText, 7);
  drawing.words(view(corner(3)) + Spot(-12, 0), "*x*", {kText, "end", 17});
}

}  // namespace

std::string draw_H9() {
  Drawing drawing(
      "H9", "Does a link recover when it is let go, and how does a triangle share a push?",
      "Left: the strength of a link falls between yields and breaks, stays when the link is let go, and "
      "goes on falling only beyond the largest stretch so far. Right: a point over a triangle; its "
      "projection divides the triangle into three areas, each the weight of the corner opposite.",
      350);
  draw_strength(drawing);
  draw_contact(drawing);
  return drawing.svg();
}

}  // namespace figures
