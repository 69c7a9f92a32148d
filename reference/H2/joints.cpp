// STAFF ONLY. Asks a student's functions of H2 and bounds the rounding errors.
#include "reference/H2/joints.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "hair/angular_springs.h"
#include "reference/H2/calls.h"

namespace grader::h2 {

using Eigen::Vector3d;

std::vector<Joint> joints(const Posed& posed) {
  std::vector<Joint> result;
  const Strand& strand = posed.strand;
  auto segment = [&](int i) -> Vector3d { return posed.x.segment<3>(3 * i + 3) - posed.x.segment<3>(3 * i); };
  auto add = [&](double stiffness, const Vector3d& e1, const Vector3d& e2, double arm) {
    if (e1.norm() == 0 || e2.norm() == 0) return;
    const Vector3d u1 = e1.normalized(), u2 = e2.normalized();
    result.push_back({stiffness, std::atan2(u1.cross(u2).norm(), u1.dot(u2)), arm});
  };
  if (strand.clamped && strand.segments() > 0)
    add(2 * strand.bend_rigidity / strand.rest_length[0], strand.root_tangent, segment(0), segment(0).norm());
  for (int i = 1; i < strand.segments(); ++i) {
    const double l = (strand.rest_length[i - 1] + strand.rest_length[i]) / 2;
    const Vector3d e1 = segment(i - 1), e2 = segment(i);
    add(strand.bend_rigidity / l, e1, e2, std::min(e1.norm(), e2.norm()));
  }
  return result;
}

double energy_rounding(const Posed& posed) {
  double sum = 0, energy = 0;
  const std::vector<Joint> all = joints(posed);
  for (const Joint& joint : all) {
    sum += 64 * kUnit * joint.stiffness * (joint.angle + 64 * kUnit);
    energy += joint.stiffness * joint.angle * joint.angle / 2;
  }
  return sum + kUnit * static_cast<double>(all.size()) * energy;
}

double force_rounding(const Posed& posed) {
  double most = 0;
  for (const Joint& joint : joints(posed)) {
    const double s = joint.angle > 2 ? std::sin(joint.angle) : 1;
    if (s > 4 * kUnit) most = std::max(most, joint.stiffness / joint.arm / s);
  }
  return 512 * kUnit * std::numbers::pi * most;
}

double product_rounding(const Posed& posed, const VectorXd& dx) {
  double most = 0;
  for (const Joint& joint : joints(posed)) {
    const double s = std::sin(joint.angle);
    if (s > 4 * kUnit) most = std::max(most, joint.stiffness / std::pow(joint.arm * s, 2));
  }
  return 512 * kUnit * std::numbers::pi * most * 4 * largest(dx);
}

double ask_energy(Trial& trial, const Posed& posed) {
  return energy_of<Calls, hair::bend_energy>(trial, posed);
}

VectorXd ask_force(Trial& trial, const Posed& posed, const VectorXd& before) {
  return sum_of<Calls, hair::add_bend_force>(trial, posed, "a force", before);
}

VectorXd ask_force(Trial& trial, const Posed& posed) {
  return ask_force(trial, posed, VectorXd::Zero(posed.x.size()));
}

VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx, const VectorXd& before,
                     int function) {
  return function == kProduct
             ? sum_of<Calls, hair::add_bend_product>(trial, posed, "a product", before, dx)
             : sum_of<Calls, hair::add_bend_product_spd>(trial, posed, "a product", before, dx);
}

VectorXd ask_product(Trial& trial, const Posed& posed, const VectorXd& dx, int function) {
  return ask_product(trial, posed, dx, VectorXd::Zero(dx.size()), function);
}

VectorXd reference_force(const Posed& posed) {
  VectorXd f = VectorXd::Zero(posed.x.size());
  hair::add_bend_force(posed.strand, posed.x, f);
  return f;
}

VectorXd ask_spd(Trial& trial, const Posed& posed, const VectorXd& dx) {
  return ask_product(trial, posed, dx, kSpdProduct);
}

VectorXd reference_product(const Posed& posed, const VectorXd& dx, int function) {
  VectorXd df = VectorXd::Zero(dx.size());
  (function == kProduct ? hair::add_bend_product : hair::add_bend_product_spd)(posed.strand, posed.x, dx, df);
  return df;
}

StrandForce strand_force() {
  StrandForce all{ask_energy,
                  ask_force,
                  [](const Posed& posed) { return hair::bend_energy(posed.strand, posed.x); },
                  reference_force,
                  {},
                  energy_rounding,
                  force_rounding,
                  product_rounding,
                  &Strand::bend_rigidity};
  for (const int function : {kProduct, kSpdProduct})
    all.products.push_back(
        {[=](Trial& trial, const Posed& posed, const VectorXd& dx, const VectorXd& before) {
           return ask_product(trial, posed, dx, before, function);
         },
         [=](const Posed& posed, const VectorXd& dx) { return reference_product(posed, dx, function); }});
  return all;
}

Posed zigzag(const Strand& strand, const Vector3d& direction, const Vector3d& aside, double bend) {
  const Vector3d across = (aside - direction * direction.dot(aside)).normalized();
  Posed posed{strand, VectorXd::Zero(3 * strand.count()), "a zigzag"};
  for (int i = 0; i + 1 < strand.count(); ++i)
    posed.x.segment<3>(3 * i + 3) = posed.x.segment<3>(3 * i) + std::cos(bend / 2) * direction +
                                    (i % 2 == 0 ? 1 : -1) * std::sin(bend / 2) * across;
  return posed;
}

bool is_balanced(const VectorXd& forces, double rounding) {
  Vector3d sum = Vector3d::Zero();
  for (Eigen::Index at = 0; at < forces.size(); at += 3) sum += forces.segment<3>(at);
  return sum.norm() <= 4 * rounding;
}

}  // namespace grader::h2
