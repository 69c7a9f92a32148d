// STAFF ONLY.
#include "grader/suite/strand_trial.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "grader/wire/strand_message.h"

namespace grader {
namespace {

using Eigen::Vector3d;

bool no_products(int, const std::vector<double>&, std::vector<double>&) {
  throw MalformedMessage("no operator");
}

MessageReader ask(Trial& trial, int function, const Posed& posed, GeometricTerm term, const VectorXd& dx,
                  const VectorXd& before) {
  trial.describe(posed.name + ", " + std::to_string(posed.strand.count()) + " particles");
  MessageWriter request;
  request.put(function).put(static_cast<int>(term));
  put(request, posed.strand);
  put(request, posed.x);
  put(request, dx);
  put(request, before);
  return trial.ask(request, no_products);
}

VectorXd finite_vector(Trial& trial, MessageReader reply, Eigen::Index size, const std::string& what) {
  VectorXd result = get_vector(reply, size);
  reply.expect_end();
  trial.expect(result.allFinite(), what + " is not a finite number");
  return result;
}

}  // namespace

double ask_energy(Trial& trial, const Posed& posed) {
  MessageReader reply = ask(trial, 0, posed, GeometricTerm::full, {}, {});
  const double energy = reply.get<double>();
  reply.expect_end();
  trial.expect(std::isfinite(energy), "the energy is not a finite number");
  return energy;
}

VectorXd ask_force(Trial& trial, const Posed& posed, const VectorXd& before) {
  return finite_vector(trial, ask(trial, 1, posed, GeometricTerm::full, {}, before), posed.x.size(),
                       "a force");
}

VectorXd ask_force(Trial& trial, const Posed& posed) {
  return ask_force(trial, posed, VectorXd::Zero(posed.x.size()));
}

VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx, const VectorXd& before,
                     GeometricTerm term, int function) {
  return finite_vector(trial, ask(trial, function, posed, term, dx, before), posed.x.size(), "a product");
}

VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx, GeometricTerm term, int function) {
  return ask_product(trial, posed, dx, VectorXd::Zero(posed.x.size()), term, function);
}

double largest(const VectorXd& v) {
  return v.size() == 0 ? 0 : v.lpNorm<Eigen::Infinity>();
}

void expect_vector(Trial& trial, const VectorXd& actual, const VectorXd& expected, double bound,
                   const std::string& what) {
  Eigen::Index worst = 0;
  const double error = (actual - expected).cwiseAbs().maxCoeff(&worst);
  std::ostringstream detail;
  detail.precision(17);
  detail << "worst entry " << worst << ": " << actual[worst] << ", expected " << expected[worst];
  trial.expect_at_most(error, bound, "the error of " + what, detail.str());
}

void expect_size(Trial& trial, double actual, double expected, const std::string& what) {
  trial.expect(actual >= expected / 100 && actual <= expected * 100,
               what + " is far too large or far too small",
               std::to_string(actual) + ", expected about " + std::to_string(expected));
}

void expect_all_equal(Trial& trial, const std::vector<double>& values, double relative,
                      const std::string& what) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  trial.expect_at_most(*most - *least, relative * std::max(std::abs(*most), std::abs(*least)), what);
}

Strand toy_strand(Random& random, int count) {
  Strand strand;
  strand.mass.resize(count);
  for (double& mass : strand.mass) mass = random.uniform(1.5, 4);
  strand.rest_length = VectorXd::Ones(count - 1);
  strand.stretch_rigidity = random.uniform(20, 90);
  strand.bend_rigidity = random.uniform(3, 9);
  strand.skip_rigidity = random.uniform(10, 40);
  return strand;
}

Posed random_pose(Random& random, const Strand& strand, Range stretch, Range bend, const std::string& name) {
  Posed posed{strand, VectorXd(3 * strand.count()), name};
  for (int i = 0; i < 3; ++i) posed.x[i] = random.normal();
  Vector3d direction = strand.clamped ? strand.root_tangent : random_direction(random);
  for (int i = 0; i < strand.segments(); ++i) {
    if (i > 0 || strand.clamped) {
      const Vector3d axis = direction.cross(random_direction(random)).normalized();
      direction = Eigen::AngleAxisd(random.uniform(bend.low, bend.high), axis) * direction;
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

Vector3d random_direction(Random& random) {
  const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * std::numbers::pi);
  const double radius = std::sqrt(1 - z * z);
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

}  // namespace grader
