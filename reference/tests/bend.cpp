// STAFF ONLY.
#include "reference/tests/bend.h"

#include <cmath>
#include <numbers>

namespace reference_tests {

VectorXd bend_force(const Strand& strand, const VectorXd& x) {
  VectorXd f = VectorXd::Zero(x.size());
  hair::add_bend_force(strand, x, f);
  return f;
}

VectorXd bend_product(const Strand& strand, const VectorXd& x, const VectorXd& dx) {
  VectorXd df = VectorXd::Zero(x.size());
  hair::add_bend_product(strand, x, dx, df);
  return df;
}

VectorXd bend_product_spd(const Strand& strand, const VectorXd& x, const VectorXd& dx) {
  VectorXd df = VectorXd::Zero(x.size());
  hair::add_bend_product_spd(strand, x, dx, df);
  return df;
}

MatrixXd bend_matrix(const Strand& strand, const VectorXd& x) {
  return matrix_of([&](const VectorXd& dx) { return bend_product(strand, x, dx); }, x.size());
}

MatrixXd bend_matrix_spd(const Strand& strand, const VectorXd& x) {
  return matrix_of([&](const VectorXd& dx) { return bend_product_spd(strand, x, dx); }, x.size());
}

Strand circle_strand(int n, double R, double EI) {
  Strand strand = test_strand(n + 2);
  strand.rest_length.setConstant(2 * R * std::sin(std::numbers::pi / n));
  strand.bend_rigidity = EI;
  return strand;
}

VectorXd circle(int n, double R) {
  VectorXd x(3 * n + 6);
  for (int i = 0; i < n + 2; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    x.segment<3>(3 * i) = R * Vector3d(std::cos(angle), std::sin(angle), 0);
  }
  return x;
}

}  // namespace reference_tests
