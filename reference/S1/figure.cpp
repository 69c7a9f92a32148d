// STAFF ONLY. S1's figure: two methods' ways to the bottom of a bowl, and the residual for four time steps.
#include <Eigen/Dense>

#include "reference/figures/drawing.h"
#include "solver/study/bowl_path.h"
#include "solver/study/history.h"

namespace figures {
namespace {

void draw_bowl(Drawing& drawing) {
  const solver::study::BowlPath path = solver::study::symmetric_path(ConjGrad);
  const Eigen::Matrix2d C{{path.xx, path.xy}, {path.xy, path.yy}};
  const Eigen::Matrix2d to_level = Eigen::Matrix2d(C.llt().matrixU()).inverse();  // maps the unit circle
  const Spot bottom(path.bottom.data()), begin(path.begin.data());
  const auto at = [&](const Spot& x) {
    return Spot(Spot(190, 175) + Spot(98, -98).cwiseProduct(x - bottom));
  };
  const double rim = std::sqrt((begin - bottom).dot(C * (begin - bottom)));
  for (const double size : {1.0, 0.8, 0.6, 0.4, 0.2})
    drawing.line(sampled(0, 2 * M_PI, 80,
                         [&](double angle) {
                           const Spot circle(std::cos(angle), std::sin(angle));
                           return at(bottom + size * rim * (to_level * circle));
                         }),
                 {kMiddle, 1});
  Spot x = begin;
  Spots zigzag = {at(x)}, conjugate;
  for (int step = 0; step < 30; ++step) {  // steepest descent
    const Spot r = C * (bottom - x);
    x += r.squaredNorm() / r.dot(C * r) * r;
    zigzag.push_back(at(x));
    if (step < 7) drawing.dot(at(x), colour(1), 3.5);
  }
  drawing.line(zigzag, {colour(1), 2.5});
  for (int step = 0; step <= 2; ++step) conjugate.push_back(at(Spot(path.places[step].data())));
  drawing.arrow(conjugate[0], conjugate[1], {colour(0), 3});
  drawing.arrow(conjugate[1], conjugate[2], {colour(0), 3});
  drawing.dot(conjugate[0]);
  drawing.words(conjugate[0] + Spot(-14, 40), "*x* = *b*", {kText, "start"});
  drawing.words(conjugate[2] + Spot(16, 28), "*A x* = *b*");
  drawing.words({16, 24}, "*φ*(*x*) from above", {kText, "start"});
  drawing.words({16, 352}, "steepest descent: a zigzag", {colour(1), "start"});
  drawing.words({16, 374}, "conjugate gradients: 2 steps", {colour(0), "start"});
}

}  // namespace

std::string draw_s1() {
  Drawing drawing("S1", 386, "How do conjugate gradients find the bottom, and when do they need long?",
                  "Two paths down a bowl: a zigzag, and two steps. Residuals for four time steps.");
  draw_bowl(drawing);
  const Plot plot = drawing.plot({448, 60, 256, 270}, {"iterations", true, 1, 1000},
                                 {"|*r*| / |*b*|, a strand of 90 unknowns", true, 1e-10, 10}, 4, 6);
  const auto draw = [&](double step, int look, const Spot& at, const char* name) {
    Spots values;
    for (const auto& progress :
         solver::study::history_of(ConjGrad, "", solver::study::strand_system(30, step), 1000, {}).progress)
      if (progress.iterations > 0)
        values.emplace_back(progress.iterations, std::sqrt(progress.squared_residual));
    drawing.curve(plot, values, {colour(look), 2.5});
    drawing.words(plot(at), name, {colour(look), "start"});
  };
  draw(1e-5, 2, {2.8, 1e-6}, "0.01 ms");
  draw(1e-4, 0, {22, 4e-2}, "0.1 ms");
  draw(1e-3, 7, {70, 1e-8}, "1 ms");
  draw(1e-2, 1, {110, 3e-5}, "*h* = 10 ms");
  return drawing.svg();
}

}  // namespace figures
