#include "solver/study/bowl_path.h"

#include <cmath>
#include <functional>

#include "solver/matrices.h"

namespace solver::study {

namespace {

// A turn of the plane.
struct Turn {
  double c, s;

  explicit Turn(double angle) : c(std::cos(angle)), s(std::sin(angle)) {}
  Place operator()(const Place& x) const { return {c * x[0] - s * x[1], s * x[0] + c * x[1]}; }
};

// The begin is far along the flat direction and near across it: steepest descent would zigzag.
constexpr Place kAlong = {2.7, 0.1};
constexpr double kFlat = 0.5, kImages = 1.7;  // angles of the flat direction and of its image, rad

// V diag(1 / kSingular, kSingular) U', turned by V = `to` and U = `from`.
SparseMatrix with_singular_values(const Turn& to, const Turn& from) {
  const double low = 1 / kSingular, high = kSingular;
  return {2,
          2,
          {{0, 0, low * to.c * from.c + high * to.s * from.s},
           {0, 1, low * to.c * from.s - high * to.s * from.c},
           {1, 0, low * to.s * from.c - high * to.c * from.s},
           {1, 1, low * to.s * from.s + high * to.c * from.c}}};
}

Place product_with(implicitMatrix& matrix, Place x) {
  Place result = {};
  matrix.matVecMult(x.data(), result.data());
  return result;
}

// `solve` takes x and the largest number of steps.
BowlPath path_of(const std::string& solver, implicitMatrix& bowl, double condition,
                 const std::function<void(Place& x, int steps)>& solve) {
  const Place x_column = product_with(bowl, {1, 0}), y_column = product_with(bowl, {0, 1});
  const Place bottom = Turn(kFlat)(kAlong);
  BowlPath path = {
      solver, x_column[0], y_column[0], y_column[1], condition, bottom, product_with(bowl, bottom), {}};
  for (int steps = 0; steps <= kMostPathSteps; ++steps) {
    // x starts with a point beyond the bottom instead of the first guess, so that a solver that starts there
    // is visible.
    Place x = {2 * bottom[0] - path.begin[0], 2 * bottom[1] - path.begin[1]};
    solve(x, steps == 0 ? -1 : steps);
    path.places.push_back(x);
    if (!std::isfinite(x[0]) || !std::isfinite(x[1])) break;
  }
  return path;
}

}  // namespace

double BowlPath::height(const Place& x) const {
  const auto above = [&](const Place& place) {
    const double dx = place[0] - bottom[0], dy = place[1] - bottom[1];
    return xx * dx * dx + 2 * xy * dx * dy + yy * dy * dy;
  };
  return above(x) / above(begin);
}

std::optional<int> BowlPath::steps_to_bottom() const {
  for (std::size_t steps = 0; steps < places.size(); ++steps)
    if (height(places[steps]) <= kBottomHeight) return static_cast<int>(steps);
  return {};
}

BowlPath symmetric_path(const ConjGradFunction& solve) {
  SparseMatrix A = with_singular_values(Turn(kFlat), Turn(kFlat));
  return path_of("ConjGrad", A, kSingular * kSingular, [&](Place& x, int steps) {
    Place b = product_with(A, Turn(kFlat)(kAlong));
    solve(2, &A, x.data(), b.data(), 0, &steps);
  });
}

BowlPath normal_path(const NormalEquationsFunction& solve) {
  SparseMatrix A = with_singular_values(Turn(kImages), Turn(kFlat)), transposed = A.transposed();
  const Place x_column = product_with(transposed, product_with(A, {1, 0})),
              y_column = product_with(transposed, product_with(A, {0, 1}));
  SparseMatrix bowl(2, 2,
                    {{0, 0, x_column[0]}, {0, 1, y_column[0]}, {1, 0, x_column[1]}, {1, 1, y_column[1]}});
  return path_of("the normal equations", bowl, std::pow(kSingular, 4), [&](Place& x, int steps) {
    Place b = product_with(A, Turn(kFlat)(kAlong));
    solve(2, 2, &A, &transposed, x.data(), b.data(), 0, &steps);
  });
}

}  // namespace solver::study
