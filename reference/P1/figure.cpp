// STAFF ONLY. P1's figure: a pendulum in the phase plane, by four methods in the same steps.
#include "hair/lab/phase/phase_plane.h"
#include "reference/figures/drawing.h"

namespace figures {

std::string draw_P1() {
  Drawing drawing(
      "P1", "Which method keeps a pendulum on its curve?",
      "Four panels, angle to the right and rate upwards, with the exact closed curve. Forward Euler "
      "winds outwards at once, midpoint slowly; symplectic Euler stays on a leaning closed curve; "
      "Runge-Kutta stays on the exact one.",
      250);
  const std::vector<hair::phase::Motion> motions = hair::phase::phase_plane();
  constexpr int kColours[] = {1, 0, 7, 2};
  for (int i = 0; i < 4; ++i) {
    const double middle = 90 + 180 * i;
    const auto at = [&](double angle, double rate) { return Spot(middle + 110 * angle, 100 - 110 * rate); };
    drawing.line({at(-0.75, 0), at(0.75, 0)}, {kFaint, 1.5});
    drawing.line({at(0, -0.75), at(0, 0.75)}, {kFaint, 1.5});
    Spots exact;
    for (int k = 0; k <= 100; ++k) {
      const double angle = hair::phase::kBegin * std::cos(M_PI * k / 50);
      const double rate = std::sqrt(std::max(0.0, 2 * (std::cos(angle) - std::cos(hair::phase::kBegin))));
      exact.push_back(at(angle, k < 50 ? -rate : rate));
    }
    drawing.line(exact, {kMiddle, 4, "none", 0.5});
    Spots way;
    for (const hair::phase::State& state : motions[i].states)
      if (std::hypot(state.angle, state.rate) < 0.78)
        way.push_back(at(state.angle, state.rate));
      else
        break;
    drawing.line(way, {colour(kColours[i]), 1, "none", 0.6});
    for (const Spot& spot : way) drawing.dot(spot, colour(kColours[i]), 2.5);
    drawing.words({middle, 208}, motions[i].method, {colour(kColours[i]), "middle", 16, "bold"});
    drawing.words({middle, 230}, "100 steps: energy × " + hair::to_text(motions[i].states.back().energy()),
                  {kText, "middle", 13});
  }
  drawing.words({176, 94}, "angle", {kQuiet, "end", 13});
  drawing.words({96, 26}, "rate", {kQuiet, "start", 13});
  return drawing.svg();
}

}  // namespace figures
