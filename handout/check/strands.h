// The inputs that the checks of H1, H2 and H3 share: strands, and answers in other units.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <initializer_list>
#include <string>

#include "derivative.h"
#include "hair/strand.h"
#include "ordinary.h"

namespace checks {

inline constexpr double kU = 0x1p-53;

// A strand of these rest lengths. It has only one rigidity that the exercise uses; the others are huge.
inline hair::Strand strand_with(double hair::Strand::*rigidity, double value,
                                const Eigen::VectorXd& rest_length) {
  const int count = static_cast<int>(rest_length.size()) + 1;
  Scatter numbers(count);
  hair::Strand strand = ordinary_strand(numbers, count);
  strand.rest_length = rest_length;
  strand.stretch_rigidity = strand.bend_rigidity = strand.skip_rigidity = 1e9;
  strand.*rigidity = value;
  return strand;
}

struct Case {
  hair::Strand strand;
  Eigen::VectorXd x;
};

// In another unit of length, 2^unit m, the answer is the same, times the unit to the `power` that the answer
// has. So no length but 0 counts as 0.
template <class Answer>
void expect_in_units(const Answer& answer, const Case& c, std::initializer_list<int> units, int power,
                     double relative, const std::string& what) {
  const Eigen::VectorXd expected = answer(c.strand, c.x);
  for (const int unit : units) {
    hair::Strand strand = c.strand;
    strand.rest_length *= std::ldexp(1.0, unit);
    expect_entries(answer(strand, c.x * std::ldexp(1.0, unit)) * std::ldexp(1.0, -power * unit), expected,
                   relative * expected.cwiseAbs().maxCoeff(),
                   what + " where all lengths are 2^" + std::to_string(unit) +
                       " times as large, in that unit. Is a length taken for 0 that is not?",
                   "rounding of the largest entry");
  }
}

// The same for a rigidity: every answer is proportional to it.
template <class Answer>
void expect_in_proportion(const Answer& answer, const Case& c, double hair::Strand::*rigidity,
                          const std::string& name, const std::string& what) {
  const Eigen::VectorXd expected = answer(c.strand, c.x);
  for (const int unit : {-70, 50}) {
    hair::Strand strand = c.strand;
    strand.*rigidity = std::ldexp(strand.*rigidity, unit);
    expect_entries(answer(strand, c.x) * std::ldexp(1.0, -unit), expected,
                   1e-12 * expected.cwiseAbs().maxCoeff(),
                   what + " where " + name + " is 2^" + std::to_string(unit) + " times as large, over that",
                   "rounding of the largest entry");
  }
}

}  // namespace checks
