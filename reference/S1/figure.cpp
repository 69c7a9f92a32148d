// STAFF ONLY. S1's figure: two methods' ways to the bottom of a bowl, and the residual for four time steps.
#include <Eigen/Dense>

#include "reference/figures/drawing.h"
#include "solver/study/bowl_path.h"
#include "solver/study/history.h"

namespace figures {

namespace {

Spots steepest_descent(const Eigen::Matrix2d& C, Spot x, const Spot& bottom) {
  Spots way = {x};
  for (int step = 0; step < 30; ++step) {
    const Spot r = C * (bottom - x);
    x += r.squaredNorm() / r.dot(C * r) * r;
    way.push_back(x);
  }
  return way;
}

void draw_bowl(Drawing& drawing) {
  const solver::study::BowlPath path = solver::study::symmetric_path(ConjGrad);
  const Eigen::Matrix2d C{{path.xx, path.xy}, {path.xy, path.yy}};
  const Eigen::Matrix2d to_level = Eigen::Matrix2d(C.llt().matrixU()).inverse();  // maps the unit circle
  const Spot bottom(path.bottom.data()), begin(path.begin.data());
  const auto at = [&](const Spot& x) {
    return Spot(Spot(190, 175) + Spot(98, -98).cwiseProduct(x - bottom));
  };
  const auto placed = [&](Spots spots) {
    for (Spot& spot : spots) spot = at(spot);
    return spots;
  };
  const double rim = std::sqrt((begin - bottom).dot(C * (begin - bottom)));
  for (const double height : {1.0, 0.64, 0.36, 0.16, 0.04}) {
    Spots level;
    for (int i = 0; i <= 80; ++i)
      level.emplace_back(bottom + std::sqrt(height) * rim * (to_level * direction(i * M_PI / 40)));
    drawing.line(placed(level), {kMiddle, 1});
  }
  const Spots zigzag = placed(steepest_descent(C, begin, bottom));
  drawing.line(zigzag, {colour(1), 2.5});
  for (int i = 1; i < 8; ++i) drawing.dot(zigzag[i], colour(1), 3.5);
  Spots conjugate;
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

void draw_residuals(Drawing& drawing) {
  const Plot plot = drawing.plot({448, 60, 256, 270}, {"iterations", true, 1, 1000},
                                 {"|*r*| / |*b*|, a strand of 90 unknowns", true, 1e-10, 10}, 4, 6);
  const struct {
    double step;
    const char* name;
    int look;
    Spot label;
    const char* anchor;
  } curves[] = {{1e-5, "0.01 ms", 2, {14, 1e-6}, "end"},
                {1e-4, "0.1 ms", 0, {22, 4e-2}, "start"},
                {1e-3, "1 ms", 7, {70, 1e-8}, "start"},
                {1e-2, "*h* = 10 ms", 1, {110, 3e-5}, "start"}};
  for (const auto& [step, name, look, label, anchor] : curves) {
    const solver::study::History history =
        solver::study::history_of(ConjGrad, "", solver::study::strand_system(30, step), 1000, {});
    Spots values;
    for (const auto& progress : history.progress)
      if (progress.iterations > 0)
        values.emplace_back(progress.iterations, std::sqrt(progress.squared_residual));
    drawing.curve(plot, values, {colour(look), 2.5});
    drawing.words(plot(label), name, {colour(look), anchor});
  }
}

}  // namespace

std::string draw_S1() {
  Drawing drawing(
      "S1", "How do conjugate gradients find the bottom of the bowl, and when do they need long?",
      "Left: from the same start steepest descent zigzags down a bowl, conjugate gradients arrive in "
      "two steps. Right: the residual of a strand's system against iterations for four time steps; "
      "the longer the step, the more iterations.",
      386);
  draw_bowl(drawing);
  draw_residuals(drawing);
  return drawing.svg();
}

}  // namespace figures
