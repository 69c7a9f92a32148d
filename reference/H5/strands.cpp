// STAFF ONLY. Draws strands and their states, and measures them.
#include "reference/H5/answers.h"

#include <Eigen/Geometry>
#include <cmath>

#include "handout/check/ordinary.h"

namespace grader::h5 {

Strand random_strand(Random& random, int n, double ratio) {
  Strand strand;
  strand.mass.resize(n);
  const double unit = random.log_uniform(1e-7, 1e-3);
  for (double& mass : strand.mass) mass = unit * (ratio > 1 ? random.log_uniform(1, ratio) : 1);
  strand.mass[0] = 1e15 * unit;
  strand.rest_length = checks::ordinary_numbers(random, n - 1, 0.7, 1.4);
  return strand;
}

VectorXd placed(Random& random, const Strand& strand, double bend) {
  VectorXd x(3 * strand.count());
  x.head<3>() = random_vector(random, 3, 0.1);
  Vector3d u = Vector3d(random_vector(random, 3)).normalized();
  for (int i = 0; i < strand.segments(); ++i) {
    u = (u + bend * random_vector(random, 3)).normalized();
    x.segment<3>(3 * i + 3) = x.segment<3>(3 * i) + strand.rest_length[i] * u;
  }
  return x;
}

VectorXd disturbed(Random& random, VectorXd x, double size) {
  x.tail(x.size() - 3) += random_vector(random, x.size() - 3, size);
  return x;
}

double largest_error(const Strand& strand, const VectorXd& x) {
  double largest = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const double l = (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).norm(), l0 = strand.rest_length[i];
    const double error = std::abs(l - l0) / l0;
    if (!(error <= largest)) largest = error;
    if (std::isnan(largest)) break;
  }
  return largest;
}

double largest_rate(const Strand& strand, const VectorXd& x, const VectorXd& v) {
  double largest = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const Vector3d u = (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).normalized();
    const double rate = std::abs(u.dot(v.segment<3>(3 * i + 3) - v.segment<3>(3 * i)));
    if (!(rate <= largest)) largest = rate;
    if (std::isnan(largest)) break;
  }
  return largest;
}

double moved(const Strand& strand, const VectorXd& from, const VectorXd& to) {
  double sum = 0;
  for (int i = 1; i < strand.count(); ++i)
    sum += strand.mass[i] * (to - from).segment<3>(3 * i).squaredNorm();
  return std::sqrt(sum);
}

double rounding(const VectorXd& x, double length) {
  return 8 * kUnit * (x.cwiseAbs().maxCoeff() / length + 1);
}

}  // namespace grader::h5
