// STAFF ONLY. Asks for a student's passes of H7, and compares them.
#include "reference/H7/answers.h"

#include <algorithm>
#include <cmath>

#include "grader/judge/case_asker.h"
#include "reference/H7/calls.h"

namespace grader::h7 {
namespace {

// The larger one; NaN if either is.
double larger(double a, double b) {
  return a >= b || std::isnan(a) ? a : b;
}

// `numbers_of` each link from `first` on.
VectorXd all_numbers(const Of& passes, std::size_t first, const auto& numbers_of) {
  VectorXd all(0);
  for (std::size_t i = first; i < passes.size(); ++i) {
    const VectorXd numbers = numbers_of(passes[i]);
    all.conservativeResize(all.size() + numbers.size());
    all.tail(numbers.size()) = numbers;
  }
  return all;
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
  Answered answered{tree.passes, {}};
  if (pass == 1) {
    ask_student_for<Calls, hair::outward_velocities>(trial, tree.links, tree.rates, answered.passes);
  } else if (pass == 2) {
    ask_student_for<Calls, hair::inward_inertias>(trial, tree.links, tree.Q, answered.passes);
  } else {
    answered.accelerations = unset(tree.rates.size());
    ask_student_for<Calls, hair::outward_accelerations>(trial, tree.links, tree.Q, answered.passes,
                                                        answered.accelerations);
  }
  return answered;
}

Answered part_of(const Tree& tree, const Answered& answered, const std::vector<int>& chosen) {
  Answered part{part_of(answered.passes, chosen), {}};
  if (answered.accelerations.size() > 0) part.accelerations = part_of(tree, answered.accelerations, chosen);
  return part;
}

double motion_error(const Of& a, const Of& b, hair::SpatialMotion LinkPass::*member, double length) {
  double largest = 0;
  for (std::size_t i = 1; i < a.size(); ++i) {
    const hair::SpatialMotion &one = a[i].*member, &other = b[i].*member;
    largest = larger(largest, length * (one.angular - other.angular).norm());
    largest = larger(largest, (one.linear - other.linear).norm());
  }
  return largest;
}

double force_error(const Of& a, const Of& b, double length, std::size_t first) {
  double largest = 0;
  for (std::size_t i = first; i < a.size(); ++i) {
    largest = larger(largest, (a[i].bias.force - b[i].bias.force).norm());
    largest = larger(largest, (a[i].bias.torque - b[i].bias.torque).norm() / length);
  }
  return largest;
}

double inertia_error(const Of& a, const Of& b, double length) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = larger(largest, (a[i].inertia.M - b[i].inertia.M).norm());
    largest = larger(largest, (a[i].inertia.H - b[i].inertia.H).norm() / length);
    largest = larger(largest, (a[i].inertia.J - b[i].inertia.J).norm() / (length * length));
  }
  return largest;
}

void expect_motions(Trial& trial, const Of& actual, const Of& expected, hair::SpatialMotion LinkPass::*member,
                    double length, double bound, const std::string& what) {
  const auto numbers = [&](const Of& passes) {
    return all_numbers(passes, 1, [&](const LinkPass& pass) {
      VectorXd motion(6);
      motion << length * (pass.*member).angular, (pass.*member).linear;
      return motion;
    });
  };
  trial.expect_at_most(motion_error(actual, expected, member, length), bound, what,
                       {numbers(actual), numbers(expected), 6});
}

void expect_forces(Trial& trial, const Of& actual, const Of& expected, double length, std::size_t first,
                   double bound, const std::string& what) {
  const auto numbers = [&](const Of& passes) {
    return all_numbers(passes, first, [&](const LinkPass& pass) { return bias_of(pass, length); });
  };
  trial.expect_at_most(force_error(actual, expected, length, first), bound, what,
                       {numbers(actual), numbers(expected), 6});
}

void expect_inertias(Trial& trial, const Of& actual, const Of& expected, double length, double bound,
                     const std::string& what) {
  const auto numbers = [&](const Of& passes) {
    return all_numbers(passes, 0, [&](const LinkPass& pass) { return inertia_of(pass, length); });
  };
  trial.expect_at_most(inertia_error(actual, expected, length), bound, what,
                       {numbers(actual), numbers(expected), 9});
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
