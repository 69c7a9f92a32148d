// STAFF ONLY. Makes strands, states and rigid motions for tests.
#include "hair/strand/test_strand_states.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace reference_tests {
namespace {

class Numbers {
 public:
  explicit Numbers(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  Vector3d direction() {
    Vector3d v;
    do v = Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    while (v.norm() > 1 || v.norm() < 0.1);
    return v.normalized();
  }

 private:
  std::mt19937 engine_;
};

struct Range {
  double low, high;
};

StrandState state(const std::string& name, int count, Range stretch, Range bend, bool clamped,
                  unsigned seed) {
  Numbers numbers(seed);
  StrandState s{name, test_strand(count), VectorXd::Zero(3 * count), 1e300};
  s.strand.clamped = clamped;
  Vector3d direction = numbers.direction();
  if (clamped) s.strand.root_tangent = direction;
  s.x.head<3>() = 2 * numbers.direction();
  for (int i = 0; i + 1 < count; ++i) {
    if (i > 0 || clamped) {
      const Vector3d axis = direction.cross(numbers.direction()).normalized();
      direction = (Eigen::AngleAxisd(numbers.uniform(bend.low, bend.high), axis) * direction).normalized();
    }
    const double length = s.strand.rest_length[i] * numbers.uniform(stretch.low, stretch.high);
    s.shortest = std::min(s.shortest, length);
    s.x.segment<3>(3 * i + 3) = s.x.segment<3>(3 * i) + length * direction;
  }
  s.least_bend = std::numbers::pi - bend.high;
  return s;
}

}  // namespace

Strand test_strand(int count) {
  Numbers numbers(7U + static_cast<unsigned>(count));
  Strand strand;
  strand.mass.resize(count);
  strand.rest_length.resize(count - 1);
  for (double& mass : strand.mass) mass = std::exp(numbers.uniform(std::log(1e-3), std::log(2.0)));
  for (double& length : strand.rest_length) length = numbers.uniform(0.5, 1.5);
  strand.stretch_rigidity = 25;
  strand.bend_rigidity = 4;
  strand.skip_rigidity = 9;
  return strand;
}

std::vector<StrandState> strand_states() {
  const double pi = std::numbers::pi;
  std::vector<StrandState> states;
  for (bool clamped : {false, true}) {
    const std::string root = clamped ? ", clamped" : "";
    for (int count : {2, 3, 7}) {
      states.push_back(state("random" + root, count, {0.6, 1.5}, {0.1, 2.5}, clamped, 1));
      states.push_back(state("stretched" + root, count, {1.1, 2}, {0.1, 1}, clamped, 2));
      states.push_back(state("compressed" + root, count, {0.3, 0.9}, {0.1, 1}, clamped, 3));
      states.push_back(state("nearly folded" + root, count, {0.6, 1.5}, {pi - 2e-3, pi - 1e-3}, clamped, 4));
      states.push_back(state("nearly straight" + root, count, {0.6, 1.5}, {1e-9, 1e-6}, clamped, 5));
      states.push_back(state("collinear" + root, count, {0.6, 1.5}, {0, 0}, clamped, 6));
      states.push_back(state("at rest" + root, count, {1, 1}, {0, 0}, clamped, 7));
      states.push_back(state("compressed to 1 %" + root, count, {0.01, 0.012}, {0.1, 1}, clamped, 8));
    }
  }
  return states;
}

MatrixXd matrix_of(const checks::Operator& product, Eigen::Index size) {
  MatrixXd K(size, size);
  for (Eigen::Index i = 0; i < size; ++i) K.col(i) = product(VectorXd::Unit(size, i));
  return K;
}

void expect_derivatives(const ForceUnderTest& f, const VectorXd& x, double length, double scale,
                        double product_scale) {
  checks::expect_force(f.force(x), f.energy, x, length, scale);
  for (int which : {1, 2}) {
    const VectorXd dx = checks::scattered_vector(static_cast<int>(x.size()), which);
    checks::expect_product(f.product(x, dx), f.force, x, dx, length, product_scale);
  }
}

void expect_no_momentum(const VectorXd& force, const VectorXd& x, double rounding) {
  checks::expect_balanced(force, x, rounding, "rounding");
}

void expect_symmetric_matrix(const MatrixXd& K, double rounding) {
  EXPECT_LE((K - K.transpose()).cwiseAbs().maxCoeff(), rounding);
}

VectorXd RigidMotion::points(const VectorXd& x) const {
  VectorXd result = vectors(x);
  for (Eigen::Index i = 0; i < x.size(); i += 3) result.segment<3>(i) += shift;
  return result;
}

VectorXd RigidMotion::vectors(const VectorXd& f) const {
  VectorXd result(f.size());
  for (Eigen::Index i = 0; i < f.size(); i += 3) result.segment<3>(i) = rotation * f.segment<3>(i);
  return result;
}

RigidMotion some_motion() {
  return {Eigen::AngleAxisd(1.1, Vector3d(2, -1, 3).normalized()).toRotationMatrix(), {0.4, -2, 1.5}};
}

}  // namespace reference_tests
