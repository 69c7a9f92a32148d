// STAFF ONLY. Asks for a student's passes of H7, and compares them.
#include "reference/H7/answers.h"

#include <algorithm>
#include <cmath>

#include "grader/judge/cases/case_asker.h"
#include "reference/H7/calls.h"

namespace grader::h7 {
namespace {

// `numbers_of` each link from `first` on.
VectorXd of_all(const Of& passes, std::size_t first, const auto& numbers_of) {
  VectorXd all(0);
  for (std::size_t i = first; i < passes.size(); ++i) {
    const VectorXd numbers = numbers_of(passes[i]);
    all.conservativeResize(all.size() + numbers.size());
    all.tail(numbers.size()) = numbers;
  }
  return all;
}

VectorXd all_motions(const Of& passes, hair::SpatialMotion LinkPass::*member, double length) {
  return of_all(passes, 1, [&](const LinkPass& pass) {
    VectorXd motion(6);
    motion << length * (pass.*member).angular, (pass.*member).linear;
    return motion;
  });
}
VectorXd all_forces(const Of& passes, double length, std::size_t first) {
  return of_all(passes, first, [&](const LinkPass& pass) { return bias_of(pass, length); });
}
VectorXd all_inertias(const Of& passes, double length) {
  return of_all(passes, 0, [&](const LinkPass& pass) { return inertia_of(pass, length); });
}

// The largest norm of `block` numbers; NaN if a number is NaN.
double largest(const VectorXd& numbers, int block) {
  const auto blocks = numbers.reshaped(block, numbers.size() / block).colwise().norm();
  return numbers.size() == 0 ? 0 : blocks.maxCoeff<Eigen::PropagateNaN>();
}

}  // namespace

VectorXd bias_of(const LinkPass& pass, double length) {
  VectorXd numbers(6);
  numbers << pass.bias.force, pass.bias.torque / length;
  return numbers;
}

VectorXd inertia_of(const LinkPass& pass, double length) {
  VectorXd numbers(27);
  numbers << pass.inertia.M.reshaped(), pass.inertia.H.reshaped() / length,
      pass.inertia.J.reshaped() / (length * length);
  return numbers;
}

Answered ask(Trial& trial, int pass, const Tree& tree) {
  trial.describe(in_words(tree));
  if (pass == 1)
    return {answer_of<Calls, hair::outward_velocities>(trial, tree.links, tree.rates, tree.passes), {}};
  if (pass == 2) return {answer_of<Calls, hair::inward_inertias>(trial, tree.links, tree.Q, tree.passes), {}};
  const auto [passes, accelerations] = answer_of<Calls, hair::outward_accelerations>(
      trial, tree.links, tree.Q, tree.passes, unset(tree.rates.size()));
  return {passes, accelerations};
}

Answered part_of(const Tree& tree, const Answered& answered, const std::vector<int>& chosen) {
  Answered part{part_of(answered.passes, chosen), {}};
  if (answered.accelerations.size() > 0) part.accelerations = part_of(tree, answered.accelerations, chosen);
  return part;
}

double motion_error(const Of& a, const Of& b, hair::SpatialMotion LinkPass::*member, double length) {
  return largest(all_motions(a, member, length) - all_motions(b, member, length), 3);
}

double force_error(const Of& a, const Of& b, double length, std::size_t first) {
  return largest(all_forces(a, length, first) - all_forces(b, length, first), 3);
}

double inertia_error(const Of& a, const Of& b, double length) {
  return largest(all_inertias(a, length) - all_inertias(b, length), 9);
}

void expect_motions(Trial& trial, const Of& actual, const Of& expected, hair::SpatialMotion LinkPass::*member,
                    double length, double bound, const std::string& what) {
  trial.expect_at_most(motion_error(actual, expected, member, length), bound, what,
                       {all_motions(actual, member, length), all_motions(expected, member, length), 6});
}

void expect_forces(Trial& trial, const Of& actual, const Of& expected, double length, std::size_t first,
                   double bound, const std::string& what) {
  trial.expect_at_most(force_error(actual, expected, length, first), bound, what,
                       {all_forces(actual, length, first), all_forces(expected, length, first), 6});
}

void expect_inertias(Trial& trial, const Of& actual, const Of& expected, double length, double bound,
                     const std::string& what) {
  trial.expect_at_most(inertia_error(actual, expected, length), bound, what,
                       {all_inertias(actual, length), all_inertias(expected, length), 9});
}

bool comparable(double own, double ours) {
  return own >= 1e-6 * ours && own <= 1e6 * ours;
}

std::string in_words(const Tree& tree) {
  std::string text = std::to_string(tree.links.size() - 1) + " links:";
  for (std::size_t i = 1; i < std::min<std::size_t>(tree.links.size(), 7); ++i)
    text += (tree.links[i].joint == JointType::revolute    ? " revolute"
             : tree.links[i].joint == JointType::prismatic ? " prismatic"
                                                           : " spherical") +
            std::string(" at ") + std::to_string(tree.links[i].parent);
  return text + (tree.rates.isZero() ? ", at rest" : ", moving");
}

}  // namespace grader::h7
