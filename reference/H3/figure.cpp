// STAFF ONLY. H3's figure: the energy of a joint with a spring that skips it, and with an angular spring.
#include "hair/angular_springs.h"
#include "hair/bend_springs.h"
#include "reference/figures/drawing.h"

namespace figures {
namespace {

// A joint of two segments of 1 m, bent by this angle in degrees.
VectorXd bent(double angle) {
  const double half = angle * M_PI / 360;
  VectorXd x = VectorXd::Zero(9);
  x.head<2>() << -std::cos(half), -std::sin(half);
  x.tail<3>() << std::cos(half), -std::sin(half), 0;
  return x;
}

}  // namespace

std::string draw_h3() {
  Drawing drawing(
      "H3", 420, "Can a spring that skips a particle resist a small bend?",
      "Energy of a joint against its angle: slope 2 for an angular spring, 4 for one that skips it.");
  const Plot plot = drawing.plot({80, 100, 600, 260}, {"angle *φ*, degrees", true, 1, 100},
                                 {"energy, J", true, 1e-9, 10}, 4, 6);
  hair::Strand strand{Eigen::Vector3d::Ones(), Eigen::Vector2d::Ones()};
  strand.bend_rigidity = strand.skip_rigidity = 1;
  const auto draw = [&](double (*energy)(const hair::Strand&, particles::Input), int look) {
    const auto at = [&](double power) {
      const double angle = std::pow(10, power);
      return plot(angle, energy(strand, bent(angle)));
    };
    drawing.line(sampled(0, std::log10(90), 20, at), {colour(look), 3});
  };
  draw(hair::bend_energy, 0);
  draw(hair::bend_spring_energy, 1);
  drawing.words(plot(10, 3e-1), "angular spring: *U* ∝ *φ*^2", {colour(0), "end"});
  drawing.words(plot(14, 3e-6), "spring that skips the joint: *U* ∝ *φ*^4", {colour(1), "start"});
  for (const double angle : {3.0, 10.0, 50.0}) {
    const View view = {plot(angle, 1) + Spot(0, -72), 42};
    const VectorXd x = bent(angle);
    const Spots spots = {view(x.head<3>()), view(x.segment<3>(3)), view(x.tail<3>())};
    drawing.line({spots[0], spots[2]}, {colour(1), 2, "3 3"});
    drawing.line(spots, {kText, 3});
    for (const Spot& spot : spots) drawing.dot(spot);
  }
  return drawing.svg();
}

}  // namespace figures
