#include "derivative.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <sstream>

#include "check.h"
#include "ordinary.h"

namespace checks {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kStep = 0x1p-14, kRelative = 1e-6, kRounding = 0x1p-36;

double largest(const VectorXd& x) {
  return x.size() == 0 ? 0 : x.lpNorm<Eigen::Infinity>();
}

// Names for the worst entry of a vector, and the way to show all of its entries.
struct Named {
  std::function<std::string(Eigen::Index entry)> entry;
  std::function<std::string(const VectorXd& all)> all;
};

Named as_particles(Eigen::Index count) {
  return {[count](Eigen::Index entry) {
            const std::string axis(1, "xyz"[entry % 3]);
            return count == 3 ? axis : "particle " + std::to_string(entry / 3) + ", " + axis;
          },
          particles_in_words};
}

std::string numbers_in_words(const VectorXd& x) {
  return in_words({x.data(), x.data() + x.size()});
}

Named as_numbers() {
  return {[](Eigen::Index entry) { return "entry " + std::to_string(entry); }, numbers_in_words};
}

Named as_matrix(Eigen::Index rows) {
  return {[rows](Eigen::Index entry) {
            return "row " + std::to_string(entry % rows) + ", column " + std::to_string(entry / rows);
          },
          [rows](const VectorXd& all) {
            std::ostringstream text;
            text << all.reshaped(rows, all.size() / rows)
                        .format(Eigen::IOFormat(6, Eigen::DontAlignCols, ", ", "; ", "", "", "[", "]"));
            return text.str();
          }};
}

std::string bound_in_words(double expected, double scale) {
  std::ostringstream text;
  text << "1e-6 of the largest expected entry, " << expected << ", + 2^-36 of " << scale
       << ": the error of central differences, see checks/derivative.h";
  return text.str();
}

}  // namespace

VectorXd force_by_differences(const Energy& energy, const VectorXd& x, double length) {
  VectorXd force(x.size()), moved = x;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    auto slope = [&](double h) {
      const double after = x[i] + h, before = x[i] - h;
      moved[i] = after;
      const double energy_after = energy(moved);
      moved[i] = before;
      // The coordinates are rounded, so the divisor is their real difference.
      return (energy_after - energy(moved)) / (after - before);
    };
    const double h = kStep * length;
    force[i] = -(4 * slope(h / 2) - slope(h)) / 3;
    moved[i] = x[i];
  }
  return force;
}

VectorXd product_by_differences(const Field& force, const VectorXd& x, const VectorXd& dx, double length) {
  const double size = largest(dx);
  if (size == 0) return VectorXd::Zero(x.size());
  const double h = kStep * length / size;
  auto slope = [&](double step) -> VectorXd {
    return (force(x + step * dx) - force(x - step * dx)) / (2 * step);
  };
  return (4 * slope(h / 2) - slope(h)) / 3;
}

namespace {

std::span<const double> span_of(const VectorXd& numbers) {
  return {numbers.data(), static_cast<std::size_t>(numbers.size())};
}

void expect_named(const VectorXd& actual, const VectorXd& expected, double bound, const std::string& what,
                  const std::string& source_of_bound, const Named& named, int block,
                  const VectorXd& before = {}) {
  ASSERT_EQ(actual.size(), expected.size());
  Eigen::Index worst = 0;
  double error = 0;
  for (Eigen::Index i = 0; i < actual.size(); ++i) {
    const double here = std::abs(actual[i] - expected[i]);
    if (here <= error) continue;
    worst = i;
    error = here;
    if (std::isnan(here)) break;
  }
  if (error <= bound) return;
  note_hint(span_of(actual), span_of(expected), bound, block, span_of(before));
  ADD_FAILURE() << what << ", the worst entry: " << named.entry(worst) << "\n"
                << "expected = " << expected[worst] << ", all of it: " << named.all(expected) << "\n"
                << "actual   = " << actual[worst] << ", all of it: " << named.all(actual) << "\n"
                << "error    = " << error << "\n"
                << "bound    = " << bound << " = " << source_of_bound;
}

}  // namespace

void expect_entries(const VectorXd& actual, const VectorXd& expected, double bound, const std::string& what,
                    const std::string& source_of_bound, const VectorXd& before) {
  const bool particles = actual.size() % 3 == 0;
  expect_named(actual, expected, bound, what, source_of_bound,
               particles ? as_particles(actual.size()) : as_numbers(), particles ? 3 : 1, before);
}

void expect_numbers(const VectorXd& actual, const VectorXd& expected, double bound, const std::string& what,
                    const std::string& source_of_bound) {
  expect_named(actual, expected, bound, what, source_of_bound, as_numbers(), 1);
}

void expect_number(double actual, double expected, double bound, const std::string& what,
                   const std::string& formula) {
  const testing::AssertionResult result =
      is_near(what.c_str(), formula.c_str(), "rounding", actual, expected, bound);
  if (!result) ADD_FAILURE() << result.message();
}

void expect_matrix(const Eigen::MatrixXd& actual, const Eigen::MatrixXd& expected, double bound,
                   const std::string& what, const std::string& source_of_bound) {
  ASSERT_EQ(actual.rows(), expected.rows()) << what;
  const int block = actual.rows() == actual.cols() ? static_cast<int>(actual.size()) : 1;
  expect_named(actual.reshaped(), expected.reshaped(), bound, what, source_of_bound, as_matrix(actual.rows()),
               block);
}

void expect_force(const VectorXd& actual, const Energy& energy, const VectorXd& x, double length,
                  double scale) {
  const VectorXd expected = force_by_differences(energy, x, length);
  expect_entries(actual, expected, kRelative * largest(expected) + kRounding * scale,
                 "the force at x = " + particles_in_words(x) + " against -dE/dx of your own energy",
                 bound_in_words(largest(expected), scale));
}

void expect_product(const VectorXd& actual, const Field& force, const VectorXd& x, const VectorXd& dx,
                    double length, double scale) {
  const VectorXd expected = product_by_differences(force, x, dx, length);
  const double size = scale * largest(dx);
  expect_entries(actual, expected, kRelative * largest(expected) + kRounding * size,
                 "(df/dx) dx at x = " + particles_in_words(x) + ", dx = " + particles_in_words(dx) +
                     ", against the change of your own force",
                 bound_in_words(largest(expected), size));
}

void expect_balanced(const VectorXd& force, const VectorXd& x, double bound,
                     const std::string& source_of_bound) {
  Vector3d sum = Vector3d::Zero(), torque = Vector3d::Zero();
  for (Eigen::Index i = 0; i + 3 <= force.size(); i += 3) {
    const Vector3d f = force.segment<3>(i);
    sum += f;
    torque += x.segment<3>(i).cross(f);
  }
  expect_entries(sum, Vector3d::Zero(), bound, "the sum of all forces, " + particles_in_words(force),
                 source_of_bound);
  expect_entries(torque, Vector3d::Zero(), bound * largest(x),
                 "the sum of all torques about the origin, of the forces " + particles_in_words(force) +
                     " at x = " + particles_in_words(x),
                 "the largest coordinate of x times that of forces: " + source_of_bound);
}

void expect_added(const std::function<void(VectorXd&)>& add, const VectorXd& before, double bound,
                  const std::string& name) {
  VectorXd from_zero = VectorXd::Zero(before.size()), sum = before;
  add(from_zero);
  add(sum);
  expect_entries(sum, before + from_zero, bound, name + ", which held " + particles_in_words(before),
                 "rounding of the largest entries");
}

void expect_symmetric(const Operator& K, const VectorXd& a, const VectorXd& b, double bound,
                      const std::string& source_of_bound) {
  const double ab = a.dot(K(b)), ba = b.dot(K(a));
  EXPECT_LE(std::abs(ab - ba), bound) << "not symmetric: a . K b = " << ab << ", but b . K a = " << ba << "\n"
                                      << "a = " << particles_in_words(a) << "\n"
                                      << "b = " << particles_in_words(b) << "\n"
                                      << "bound = " << source_of_bound;
}

VectorXd vector(std::initializer_list<double> values) {
  return Eigen::Map<const VectorXd>(values.begin(), static_cast<Eigen::Index>(values.size()));
}

VectorXd scattered_vector(int n, int which) {
  Scatter numbers(which);
  VectorXd values(n);
  for (double& value : values) value = numbers.uniform(-1, 1);
  return values;
}

std::string particles_in_words(const VectorXd& x) {
  const Eigen::Index count = x.size() / 3, shown = count <= 8 ? count : 6;
  std::ostringstream text;
  for (Eigen::Index i = 0; i < shown; ++i)
    text << (i == 0 ? "(" : " (") << x[3 * i] << ", " << x[3 * i + 1] << ", " << x[3 * i + 2] << ")";
  if (shown < count) text << " ... " << count - shown << " more";
  return text.str();
}

}  // namespace checks
