// Central differences for the checks of forces, and comparisons that print each error with its bound.
//
//   D(h) = (g(x + h) - g(x - h)) / 2h = g'(x) + h^2 g'''/6 + ...,    g'(x) = (4 D(h/2) - D(h)) / 3 + O(h^4)
//
// With h = 2^-14 (6e-5) of `length`, the length over which g changes by its own size, the second formula
// (Richardson's) is off by no more than rounding is. Rounding of g is divided by h, and so becomes 2^-38
// (4e-12) of g's size over `length`. So both values agree to
//
//   1e-6 of the largest entry + 2^-36 of `scale`.
//
// An entry has the size `scale` when lengths and angles are off by all of themselves. The second part of the
// bound is for entries that should be 0, but round.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <initializer_list>
#include <string>

namespace checks {

using Energy = std::function<double(const Eigen::VectorXd& x)>;
using Field = std::function<Eigen::VectorXd(const Eigen::VectorXd& x)>;  // the forces at positions x
using Operator = std::function<Eigen::VectorXd(const Eigen::VectorXd& dx)>;

// -dE/dx, entry by entry.
Eigen::VectorXd force_by_differences(const Energy& energy, const Eigen::VectorXd& x, double length);

// (df/dx) dx: the change of f along dx, for a step that moves no coordinate by more than h.
Eigen::VectorXd product_by_differences(const Field& force, const Eigen::VectorXd& x,
                                       const Eigen::VectorXd& dx, double length);

// `actual` is the force that belongs to `energy`.
void expect_force(const Eigen::VectorXd& actual, const Energy& energy, const Eigen::VectorXd& x,
                  double length, double scale);

// `actual` is (df/dx) dx; `scale` as above, for a dx whose largest entry is 1.
void expect_product(const Eigen::VectorXd& actual, const Field& force, const Eigen::VectorXd& x,
                    const Eigen::VectorXd& dx, double length, double scale);

// No entry of `actual` is off by more than `bound`. A failure names the entries by `what`, and shows the
// worst one. Three entries are a vector, more are particles. `before`, if given, is the input, or the
// output's numbers before the call.
void expect_entries(const Eigen::VectorXd& actual, const Eigen::VectorXd& expected, double bound,
                    const std::string& what, const std::string& source_of_bound = "rounding",
                    const Eigen::VectorXd& before = {});

// The same for joints' rates, curvatures and other numbers that belong to no particle.
void expect_numbers(const Eigen::VectorXd& actual, const Eigen::VectorXd& expected, double bound,
                    const std::string& what, const std::string& source_of_bound = "rounding");

// One number; the words say what it is and how it is calculated.
void expect_number(double actual, double expected, double bound, const std::string& what,
                   const std::string& formula);

void expect_matrix(const Eigen::MatrixXd& actual, const Eigen::MatrixXd& expected, double bound,
                   const std::string& what, const std::string& source_of_bound = "rounding");

// The forces on all particles add up to no force and no torque, to within `bound` N and `bound` times the
// largest coordinate of x.
void expect_balanced(const Eigen::VectorXd& force, const Eigen::VectorXd& x, double bound,
                     const std::string& source_of_bound = "rounding");

// `add` adds to its argument, and keeps the numbers in it. Failures call the argument `name`.
void expect_added(const std::function<void(Eigen::VectorXd&)>& add, const Eigen::VectorXd& before,
                  double bound, const std::string& name);

// a . (K b) = b . (K a), to within `bound`.
void expect_symmetric(const Operator& K, const Eigen::VectorXd& a, const Eigen::VectorXd& b, double bound,
                      const std::string& source_of_bound = "rounding");

Eigen::VectorXd vector(std::initializer_list<double> values);

// n numbers between -1 and 1 without a pattern, the same ones for the same `which`.
Eigen::VectorXd scattered_vector(int n, int which);

// "(0, 0, 0) (0, 0, -0.01) ...": three coordinates a particle, of a long vector the first six particles.
std::string particles_in_words(const Eigen::VectorXd& x);

}  // namespace checks
