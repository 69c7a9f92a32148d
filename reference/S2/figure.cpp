// STAFF ONLY. S2's figure: the digits that A'A loses.
#include "reference/figures/drawing.h"
#include "solver/normal_equations.h"
#include "solver/study/normal_digits.h"

namespace figures {

std::string draw_s2() {
  Drawing drawing("S2", 430, "How many digits do the normal equations lose?",
                  "Error of x against A's condition number: slope 1 for QR, slope 2 for two methods on A'A.");
  const Plot plot = drawing.plot({70, 50, 620, 320}, {"condition number of *A*", true, 10, 1e9},
                                 {"relative error of *x*", true, 1e-17, 10}, 8, 9);
  Spots errors[3];
  for (double exponent = 1; exponent <= 9; exponent += 0.5) {
    const double condition = std::pow(10, exponent);
    const solver::study::DigitsLost lost =
        solver::study::digits_lost(solve_normal_equations, condition, 9, 40000);
    errors[0].emplace_back(condition, lost.qr);
    if (std::isfinite(lost.cholesky)) errors[1].emplace_back(condition, lost.cholesky);
    if (!lost.stopped) errors[2].emplace_back(condition, lost.conj_grad);
  }
  drawing.words(plot(3e7, 1.5e-8), "slope 1", {kQuiet, "end"});
  drawing.words(plot(3e6, 2e-2), "slope 2", {kQuiet, "end"});
  for (const int slope : {1, 2}) {
    Spots guide;
    for (double c = 10; c <= 1e9; c *= 1.2)
      guide.emplace_back(c, solver::study::kRounding * std::pow(c, slope));
    drawing.curve(plot, guide, {kMiddle, 1.2, "5 4"});
  }
  constexpr int kColours[] = {2, 1, 0};
  for (int i = 0; i < 3; ++i) {
    drawing.curve(plot, errors[i], {colour(kColours[i]), 2.5});
    for (const Spot& error : errors[i])
      if (plot.y.contains(error[1])) drawing.dot(plot(error), colour(kColours[i]), 3.5);
  }
  drawing.words(plot(4e7, 4e-12), "QR of *A*", {colour(2), "start"});
  drawing.words(plot(8e6, 2e-6), "Cholesky of *A*^T*A*;", {colour(1), "start"});
  drawing.words(plot(8e6, 2e-6) + Spot(0, 20), "no factor at 10^9", {colour(1), "start"});
  drawing.words(plot(2e3, 1e-8), "ConjGrad on *A*^T*A*;", {colour(0), "end"});
  drawing.words(plot(2e3, 1e-8) + Spot(0, 20), "no end beyond 10^6", {colour(0), "end"});
  return drawing.svg();
}

}  // namespace figures
