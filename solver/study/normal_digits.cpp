#include "solver/study/normal_digits.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/study/systems.h"

namespace solver::study {

namespace {

constexpr double kSomeRoundings = 4;

using Eigen::MatrixXd;
using Eigen::VectorXd;

// A table, or its transpose.
class Dense : public implicitMatrix {
 public:
  explicit Dense(MatrixXd A) : A_(std::move(A)) {}
  void matVecMult(double x[], double b[]) override {
    Eigen::Map<VectorXd>(b, A_.rows()).noalias() = A_ * Eigen::Map<const VectorXd>(x, A_.cols());
  }

 private:
  MatrixXd A_;
};

VectorXd random_vector(int n, unsigned seed) {
  const Vector values = scattered(n, seed);
  return Eigen::Map<const VectorXd>(values.data(), n);
}

// U diag(s) V', U and V products of Householder reflections.
MatrixXd with_singular_values(const Vector& s, unsigned seed) {
  const int n = static_cast<int>(s.size());
  MatrixXd A = Eigen::Map<const VectorXd>(s.data(), n).asDiagonal();
  for (unsigned k = 0; k < 3; ++k) {
    const VectorXd u = random_vector(n, seed + 2 * k).normalized(),
                   v = random_vector(n, seed + 2 * k + 1).normalized();
    A -= 2 * u * (u.transpose() * A).eval();
    A -= 2 * (A * v).eval() * v.transpose();
  }
  return A;
}

double median(Vector values) {
  // NaN counts as worse than any number.
  for (double& value : values)
    if (!std::isfinite(value)) value = std::numeric_limits<double>::infinity();
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  const double middle = values[values.size() / 2];
  return std::isinf(middle) ? std::numeric_limits<double>::quiet_NaN() : middle;
}

}  // namespace

DigitsLost digits_lost(const NormalEquationsFunction& solve, double condition, int draws,
                       int most_iterations) {
  constexpr int n = kDigitsUnknowns;
  Vector conj_grad, cholesky, qr, iterations;
  for (int draw = 0; draw < draws; ++draw) {
    const MatrixXd A = with_singular_values(log_spaced(n, 1 / condition, 1), 100 * draw + 1);
    const VectorXd exact = random_vector(n, 100 * draw + 99);
    VectorXd b = A * exact;
    const auto error = [&](const VectorXd& x) { return (x - exact).norm() / exact.norm(); };

    Dense straight(A), transposed(A.transpose());
    VectorXd x(n);
    int steps = most_iterations;
    // ||A|| = 1, so a product with A'A is rounded by some u ||x||: smaller residuals have no meaning.
    const double epsilon = std::pow(kSomeRoundings * kRounding * exact.norm(), 2);
    solve(n, n, &straight, &transposed, x.data(), b.data(), epsilon, &steps);
    conj_grad.push_back(error(x));
    iterations.push_back(steps);

    const Eigen::LLT<MatrixXd> llt(A.transpose() * A);
    cholesky.push_back(llt.info() == Eigen::Success ? error(llt.solve(A.transpose() * b))
                                                    : std::numeric_limits<double>::quiet_NaN());
    qr.push_back(error(A.householderQr().solve(b)));
  }
  const int taken = static_cast<int>(median(iterations));
  return {condition, median(conj_grad), taken, taken >= most_iterations, median(cholesky), median(qr)};
}

}  // namespace solver::study
