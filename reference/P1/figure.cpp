// STAFF ONLY. P1's figure: a pendulum in the phase plane, by four methods in the same steps.
#include "hair/lab/phase/phase_plane.h"
#include "reference/figures/drawing.h"

namespace figures {

std::string draw_p1() {
  using hair::phase::kBegin;
  Drawing drawing("P1", 272, "Which method keeps a pendulum on its curve?",
                  "Phase planes: two methods wind outwards, symplectic Euler leans, Runge-Kutta fits.");
  int look = 0;
  for (const hair::phase::Motion& motion : hair::phase::phase_plane()) {
    const double middle = 90 + 180 * look;
    const auto at = [&](double angle, double rate) { return Spot(middle + 110 * angle, 100 - 110 * rate); };
    drawing.line({at(-0.75, 0), at(0.75, 0)}, {kFaint, 1.5});
    drawing.line({at(0, -0.75), at(0, 0.75)}, {kFaint, 1.5});
    const auto exact = [&](double turn) {
      const double angle = kBegin * std::cos(turn);
      const double rate = std::sqrt(std::max(0.0, 2 * (std::cos(angle) - std::cos(kBegin))));
      return at(angle, turn < M_PI ? -rate : rate);
    };
    drawing.line(sampled(0, 2 * M_PI, 100, exact), {kMiddle, 4, "none", 0.5});
    const std::string hue = colour(std::array{1, 0, 7, 2}[look++]);
    Spots way;
    for (const auto& [angle, rate] : motion.states) {
      if (std::hypot(angle, rate) > 0.78) break;
      way.push_back(at(angle, rate));
      drawing.dot(way.back(), hue, 2.5);
    }
    drawing.line(way, {hue, 1, "none", 0.6});
    drawing.words({middle, 208}, motion.method, {hue, "middle", 16, "bold"});
    drawing.words({middle, 230}, "energy × " + hair::to_text(motion.states.back().energy()));
  }
  drawing.words({360, 262}, "after 100 steps of 0.3 s; forward Euler goes on outside", {kQuiet});
  drawing.words({190, 94}, "angle", {kQuiet, "end", 13});
  drawing.words({96, 26}, "rate", {kQuiet, "start", 13});
  return drawing.svg();
}

}  // namespace figures
