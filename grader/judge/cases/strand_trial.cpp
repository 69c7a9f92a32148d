// STAFF ONLY. Asks about strands and compares the answers with the reference's.
#include "grader/judge/cases/strand_trial.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>

namespace grader::inline judge {

using Eigen::Vector3d;

void describe(Trial& trial, const Posed& posed) {
  trial.describe(posed.name + ", " + std::to_string(posed.strand.count()) + " particles");
}

double largest(const VectorXd& v) {
  return v.size() == 0 ? 0 : v.lpNorm<Eigen::Infinity>();
}

void expect_vector(Trial& trial, const VectorXd& actual, const VectorXd& expected, double bound,
                   const std::string& what) {
  trial.expect_near({actual, expected}, bound, "the error of " + what);
}

void expect_size(Trial& trial, double actual, double expected, const std::string& what) {
  trial.expect(actual >= expected / 100 && actual <= expected * 100,
               what + " is far too large or far too small",
               std::to_string(actual) + ", expected about " + std::to_string(expected));
}

void expect_not_zero(Trial& trial, const VectorXd& actual, const std::string& what) {
  trial.expect(largest(actual) > 0, what + " is 0");
}

void InUnits::expect(const VectorXd& actual, double metre, double newton) {
  expect_not_zero(trial_, expected_, what_);
  expect_not_zero(trial_, actual, what_);
  const double most = largest(expected_), seen = largest(actual);
  if (most == 0 || seen == 0) return;
  expect_vector(trial_, actual / seen, expected_ / most, 2 * rounding_ / most, what_);
  const double factor = seen / most / newton;
  if (metre != 1 && !power_) power_ = std::round(std::log2(factor) / std::log2(metre));
  trial_.expect_at_most(std::abs(factor / std::pow(metre, power_.value_or(0)) - 1), 4 * rounding_ / most,
                        "the relative error of the size of " + what_);
}

void expect_all_equal(Trial& trial, const std::vector<double>& values, double relative,
                      const std::string& what) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  trial.expect_at_most(*most - *least, relative * std::max(std::abs(*most), std::abs(*least)), what);
}

Strand even_strand(Random& random, int count, double metres) {
  Strand strand = checks::ordinary_strand(random, count);
  strand.rest_length.setConstant(metres);
  return strand;
}

Posed random_pose(Random& random, const Strand& strand, Range stretch, Range bend, const std::string& name) {
  Posed posed{strand, VectorXd(3 * strand.count()), name};
  for (int i = 0; i < 3; ++i) posed.x[i] = random.uniform(-2, 2);
  Vector3d direction = strand.clamped ? strand.root_tangent : checks::ordinary_direction(random);
  for (int i = 0; i < strand.segments(); ++i) {
    if (i > 0 || strand.clamped) {
      const Vector3d aside = checks::ordinary_direction(random), axis = direction.cross(aside).normalized();
      direction = Eigen::AngleAxisd(random.uniform(bend.low, bend.high), axis) * direction;
      // Cosines differ by processor in their last bit.
      direction = direction.unaryExpr(&Random::on_grid).eval().normalized();
    }
    const double length = strand.rest_length[i] * random.uniform(stretch.low, stretch.high);
    posed.x.segment<3>(3 * i + 3) = posed.x.segment<3>(3 * i) + length * direction;
  }
  return posed;
}

Posed straight_pose(const Strand& strand, const VectorXd& lengths, const Vector3d& direction,
                    const std::string& name) {
  Posed posed{strand, VectorXd::Zero(3 * strand.count()), name};
  for (int i = 0; i < strand.segments(); ++i)
    posed.x.segment<3>(3 * i + 3) = posed.x.segment<3>(3 * i) + lengths[i] * direction;
  return posed;
}

Posed part_of(const Posed& posed, int first, int count) {
  Posed part{posed.strand, posed.x.segment(3 * first, 3 * count), posed.name + ", a part of it alone"};
  part.strand.mass = posed.strand.mass.segment(first, count);
  part.strand.rest_length = posed.strand.rest_length.segment(first, count - 1);
  part.strand.clamped = posed.strand.clamped && first == 0;
  return part;
}

}  // namespace grader::judge
