// STAFF ONLY. Shared code of the hidden cases of H1, H2 and H3: calls of a student's functions on strands,
// strands and states as inputs, and comparisons with the reference.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "grader/judge/cases/case_asker.h"
#include "grader/judge/cases/random.h"
#include "grader/judge/cases/trial.h"
#include "hair/geometric_term.h"
#include "hair/strand.h"
#include "handout/check/ordinary.h"

namespace grader::inline judge {

using Eigen::VectorXd;
using hair::GeometricTerm;
using hair::Strand;

// Holds a strand with its positions.
struct Posed {
  Strand strand;
  VectorXd x;
  std::string name;  // for staff
};

void describe(Trial& trial, const Posed& posed);

// These call a student's function on a strand, and check that the answer is finite.
template <class Calls, auto energy>
double energy_of(Trial& trial, const Posed& posed) {
  describe(trial, posed);
  const double answer = answer_of<Calls, energy>(trial, posed.strand, posed.x);
  trial.expect(std::isfinite(answer), "the energy is not a finite number");
  return answer;
}
// Returns the buffer after the call; the function adds to its content, `before`.
template <class Calls, auto add, class... Arguments>
VectorXd sum_of(Trial& trial, const Posed& posed, const std::string& what, const VectorXd& before,
                const Arguments&... arguments) {
  describe(trial, posed);
  const VectorXd sum = answer_of<Calls, add>(trial, posed.strand, posed.x, arguments..., before);
  trial.expect(sum.allFinite(), what + " is not a finite number");
  return sum;
}

// Returns the largest absolute value of an entry.
double largest(const VectorXd& v);

// Checks that no entry is off by more than `bound`.
void expect_vector(Trial& trial, const VectorXd& actual, const VectorXd& expected, double bound,
                   const std::string& what);

// Checks that a value is between 1/100 and 100 times the expected one. Cases that test another property call
// it: zeros must not have the property, and an unrelated mistake must not cost it.
void expect_size(Trial& trial, double actual, double expected, const std::string& what);

// For cases that compare a student's answers with each other: zeros must not have the property.
void expect_not_zero(Trial& trial, const VectorXd& actual, const std::string& what);

// Holds an answer in other units of length and force, `metre` and `newton` times ours: each number is the old
// one times newton, times a power of metre. Another category tests which power; here it must be the same in
// all units. No entry, over the largest one, is off by more than `rounding` over the largest of `expected`.
class InUnits {
 public:
  InUnits(Trial& trial, VectorXd expected, double rounding, std::string what)
      : trial_(trial), expected_(std::move(expected)), rounding_(rounding), what_(std::move(what)) {}

  void expect(const VectorXd& actual, double metre, double newton);

 private:
  Trial& trial_;
  VectorXd expected_;
  double rounding_;
  std::string what_;
  std::optional<double> power_ = {};
};

// Checks that the numbers differ by at most `relative` times the largest.
void expect_all_equal(Trial& trial, const std::vector<double>& values, double relative,
                      const std::string& what);

// Makes a strand of handout/check/ordinary.h with rest lengths `metres`: one category alone tests rest
// lengths and the parts of constants.
Strand even_strand(Random& random, int count, double metres = 1);

struct Range {
  double low, high;
};

// Makes a random pose: segments have `stretch` times their rest length, and each is turned from the previous
// one by an angle in `bend` about an ordinary axis. The root's position and the first direction are random
// (if clamped, root_tangent is random and the first segment is turned from it likewise).
Posed random_pose(Random& random, const Strand& strand, Range stretch, Range bend, const std::string& name);

// Makes a pose on a line through the root: segments of the given lengths along `direction`.
Posed straight_pose(const Strand& strand, const VectorXd& lengths, const Eigen::Vector3d& direction,
                    const std::string& name);

// Takes `count` particles from number `first` on, as a strand; only a part with its root is clamped.
Posed part_of(const Posed& posed, int first, int count);

}  // namespace grader::judge
