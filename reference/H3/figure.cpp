// STAFF ONLY. H3's figure: the energy of a joint with a spring that skips it, and with an angular spring.
#include "hair/angular_springs.h"
#include "hair/bend_springs.h"
#include "reference/figures/drawing.h"

namespace figures {

namespace {

Eigen::VectorXd bent(double angle) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(9);
  x.head<3>() << -std::cos(angle / 2), -std::sin(angle / 2), 0;
  x.tail<3>() << std::cos(angle / 2), -std::sin(angle / 2), 0;
  return x;
}

// The joint as it looks, with the spring that skips it.
void draw_bent(Drawing& drawing, const Spot& middle, double angle) {
  const View view = {middle, 42};
  const Eigen::VectorXd x = bent(angle);
  const Spots spots = {view(x.head<3>()), view(x.segment<3>(3)), view(x.tail<3>())};
  drawing.line({spots[0], spots[2]}, {colour(1), 2, "3 3"});
  drawing.line(spots, {kText, 3});
  for (const Spot& spot : spots) drawing.dot(spot, kText, 4);
}

}  // namespace

std::string draw_H3() {
  Drawing drawing(
      "H3", "Can a spring that skips a particle resist a small bend?",
      "Energy of a joint against its angle, both logarithmic. The angular spring has slope 2; the "
      "spring that skips the joint has slope 4 and at one degree a hundred-thousandth of the energy.",
      420);
  const Plot plot =
      drawing.plot({80, 100, 600, 260}, {"angle *φ*, degrees", true, 1, 100}, {"", true, 1e-9, 10}, 4, 6);
  drawing.words({60, 88}, "energy, J", {kText, "start"});
  hair::Strand strand;
  strand.mass = Eigen::Vector3d::Ones();
  strand.rest_length = Eigen::Vector2d::Ones();
  strand.bend_rigidity = strand.skip_rigidity = 1;
  Spots skipping, angular;
  for (double angle = 1; angle < 91; angle *= 1.1) {
    const Eigen::VectorXd x = bent(angle * M_PI / 180);
    skipping.emplace_back(angle, hair::bend_spring_energy(strand, x));
    angular.emplace_back(angle, hair::bend_energy(strand, x));
  }
  drawing.curve(plot, angular, {colour(0), 3});
  drawing.curve(plot, skipping, {colour(1), 3});
  drawing.words(plot(10, 3e-1), "angular spring: *E* ∝ *φ*^2", {colour(0), "end"});
  drawing.words(plot(14, 3e-6), "spring that skips the joint: *E* ∝ *φ*^4", {colour(1), "start"});
  for (const double angle : {2.0, 10.0, 50.0})
    draw_bent(drawing, plot(angle, 1) + Spot(0, -72), angle * M_PI / 180);
  return drawing.svg();
}

}  // namespace figures
