// STAFF ONLY. H4: hidden cases of implicit_matrix, implicit_rhs, solve_plain and implicit_euler.
//
// Each part of the matrix is checked by itself: masses without any force, and stiffness or damping as an
// addition to the student's own product without them. Pinned particles, units and the step are compared with
// the student's own matrix and right-hand side, so that a mistake in these costs nothing there.

#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "grader/judge/cases/random.h"
#include "reference/H4/answers.h"

namespace grader::h4 {
namespace {

using Eigen::VectorXd;

// The rounding of 3n terms in each of the two products, and of their sum.
double rounding(const ImplicitSystem& system, const VectorXd& x) {
  return 4 * static_cast<double>(x.size() + 8) * kUnit * system.norm * x.norm();
}

VectorXd masses_times(const Cloud& cloud, const VectorXd& x) {
  return cloud.particles.mass.transpose().replicate(3, 1).reshaped().cwiseProduct(x);
}

// `without` is the product without a force, the student's own or the right one. The output holds `junk`
// before.
void expect_product(Trial& trial, const Cloud& cloud, double a, double b, const VectorXd& x,
                    const VectorXd& without, double junk = 0) {
  const ImplicitSystem system = implicit_system(cloud, a, b);
  const VectorXd expected = without + (system.A * x - masses_times(cloud, x));
  const Product answer = multiply(trial, cloud, a, b, x, junk);
  trial.expect_close({answer.product, expected, 3, x}, 2 * rounding(system, x) + 8 * kUnit * without.norm(),
                     "the error of the matrix' product");
  trial.expect(answer.product == answer.again, "the matrix' product is another one the second time");
  trial.expect(answer.x == x, "the matrix' product changes its input");
}

std::pair<double, double> two_times(Random& random) {
  const double a = random.uniform(0.2, 0.5);
  return {a, a + random.uniform(0.1, 0.4)};
}

}  // namespace

void matrix(Trial& trial) {
  for (int n : {1, 2, 5, 12}) {
    const auto [a, b] = two_times(trial.random);
    const Cloud cloud = mixed_cloud(trial.random, n, Parts::dfdx);
    const VectorXd x = random_vector(trial.random, 3 * n),
                   without = multiply(trial, with(cloud, Parts::none), a, b, x).product;
    for (double junk : {0.0, 1e3, std::numeric_limits<double>::quiet_NaN()})
      expect_product(trial, cloud, a, b, x, without, junk);
  }
}

void damping(Trial& trial) {
  Random& random = trial.random;
  for (int n : {1, 4, 9}) {
    const auto times = two_times(random);
    const double a = times.first, b = times.second;
    Cloud cloud = mixed_cloud(random, n, Parts::all);
    const VectorXd x = random_vector(random, 3 * n);
    const auto product = [&](Parts parts) { return multiply(trial, with(cloud, parts), a, b, x).product; };
    const VectorXd none = product(Parts::none);
    expect_product(trial, with(cloud, Parts::dfdv), a, b, x, none);
    // With both derivatives the product is the masses' plus both additions.
    const VectorXd both = product(Parts::all), one = product(Parts::dfdx), other = product(Parts::dfdv);
    trial.expect_at_most(
        (both - one - other + none).norm(),
        16 * (3 * n + 8) * kUnit * (implicit_system(cloud, a, b).norm * x.norm() + both.norm()),
        "the matrix' product with both derivatives, without those with each of them: what is left",
        {both, one + other - none, 3, x});
  }
}

void masses(Trial& trial) {
  Random& random = trial.random;
  for (int n : {1, 3, 8}) {
    const double unit = random.log_uniform(1e-6, 1e-3);
    const Cloud cloud = with(
        random_cloud(random, "light particles, masses 1:100", n, unit, 100 * unit, unit, 0), Parts::none);
    const auto [a, b] = two_times(random);
    const VectorXd x = random_vector(random, 3 * n);
    expect_product(trial, cloud, a, b, x, masses_times(cloud, x));
  }
}

namespace {

void expect_same_where_free(Trial& trial, const Cloud& pinned, const VectorXd& one, const VectorXd& other,
                            const std::string& what) {
  for (int i = 0; i < pinned.count(); ++i)
    if (!pinned.particles.is_pinned(i))
      trial.expect_at_most((one - other).segment<3>(3 * i).norm(), 1e-9 * one.norm(), what,
                           {one.segment<3>(3 * i), other.segment<3>(3 * i)});
}

}  // namespace

void pinned(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 3, 6}) {
    const Cloud free = mixed_cloud(random, n, Parts::dfdx);
    Cloud cloud = free;
    cloud.name += ", some pinned";
    cloud.particles.pinned[random.integer(0, n - 1)] = 1;
    if (n > 3) cloud.particles.pinned[0] = cloud.particles.pinned[n - 1] = 1;
    const auto [a, b] = two_times(random);
    const VectorXd x = random_vector(random, 3 * n);
    VectorXd still = x;
    for (int i = 0; i < n; ++i)
      if (cloud.particles.is_pinned(i)) still.segment<3>(3 * i).setZero();
    const VectorXd product = multiply(trial, cloud, a, b, x).product,
                   rhs = right_side(trial, cloud, a, b).rhs;
    for (int i = 0; i < n; ++i) {
      if (!cloud.particles.is_pinned(i)) continue;
      trial.expect(product.segment<3>(3 * i) == x.segment<3>(3 * i),
                   "the row of a pinned particle is not that of the identity");
      trial.expect(rhs.segment<3>(3 * i).isZero(0), "the right-hand side of a pinned particle is not 0");
    }
    expect_same_where_free(trial, cloud, product, multiply(trial, cloud, a, b, still).product,
                           "how much the column of a pinned particle adds to a product");
    expect_same_where_free(trial, cloud, product, multiply(trial, free, a, b, still).product,
                           "how much a product for free particles changes if others are pinned");
    expect_same_where_free(trial, cloud, rhs, right_side(trial, free, a, b).rhs,
                           "how much the right-hand side of free particles changes if others are pinned");

    const double h = random.uniform(0.2, 0.8);
    Cloud hair = soft_hair(random, n + 1, h, true);
    hair.particles.pinned[0] = hair.particles.pinned[n] = 1;
    const Step after = step(trial, hair, h);
    if (!after.v.allFinite()) continue;  // the category of steps is about this
    for (int i : {0, n}) {
      // The product rounds by u of the way, sum and difference by u of the position. Twice that allows for
      // any order.
      const VectorXd v = hair.state.v.segment<3>(3 * i), way = h * v;
      trial.expect(after.v.segment<3>(3 * i) == v, "a step changes the velocity of a pinned particle");
      trial.expect_close({(after.x - hair.state.x).segment<3>(3 * i), way},
                         8 * kUnit * (hair.state.x.norm() + way.norm()),
                         "the error of how far a pinned particle moves in a step");
    }
  }
}

void right_side(Trial& trial) {
  Random& random = trial.random;
  for (int n : {1, 2, 5, 12}) {
    const Cloud cloud = mixed_cloud(random, n, Parts::all);
    const auto [a, b] = two_times(random);
    VectorXd f = VectorXd::Zero(3 * n), Kv = f;
    cloud.force->add_force(cloud.state.x, cloud.state.v, f);
    cloud.force->add_dfdx(cloud.state.x, cloud.state.v, cloud.state.v, Kv);
    const double size = a * (f.norm() + b * Kv.norm());
    // A sum with numbers that are there already rounds once more, by their size.
    trial.expect_close(
        {right_side(trial, cloud, a, b, std::numeric_limits<double>::quiet_NaN()).rhs, a * (f + b * Kv)},
        8 * (3 * n + 8) * kUnit * size, "the error of the right-hand side");
  }
}

// Springs are so weak that each matrix with such entries, of any sign, is positive definite.
void step(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 10}) {
    const double h = random.uniform(0.2, 0.8);
    const Cloud hair = soft_hair(random, n, h, true);
    const Step after = step(trial, hair, h);
    const VectorXd dv = after.v - hair.state.v, rhs = right_side(trial, hair, h, h).rhs;
    trial.expect_close({multiply(trial, hair, h, h, dv).product, rhs},
                       1e-6 * rhs.norm() + 16 * kUnit * hair.state.v.norm(),
                       "the residual of a step in your own matrix and right-hand side, a = b = h");
    const VectorXd x = hair.state.x + h * after.v;
    trial.expect_close({after.x, x, 3, hair.state.x}, 4 * kUnit * (x.norm() + h * after.v.norm()),
                       "the difference between x and the old x + h times the new v");
    trial.expect(after.report.preconditioned && after.report.converged,
                 "a step does not return the report of solve_implicit");
  }
  // Without a preconditioner the tolerance decides how many steps it takes.
  const double h = random.uniform(0.2, 0.8);
  const Cloud hair = soft_hair(random, 12, h, false);
  const int fine = step(trial, hair, h).report.steps, coarse = step(trial, hair, h, 1e-2).report.steps;
  trial.expect(coarse < fine, "a step with a tolerance of 1e-2 takes as many iterations as one of 1e-10",
               std::to_string(coarse) + " and " + std::to_string(fine));
}

void cost(Trial& trial) {
  Random& random = trial.random;
  for (int n : {4, 16}) {
    const double h = random.uniform(0.2, 0.8);
    const Cloud hair = soft_hair(random, n, h, true);
    // A student takes two products, or writes the matrix out first, with 3n of each kind.
    const Asked products = multiply(trial, hair, h, h, random_vector(random, 3 * n)).asked;
    for (const int count : {products.dfdx, products.dfdv})
      trial.expect(count <= 2 || count == 3 * n,
                   "a product takes more products with df/dx and df/dv than one of each",
                   std::to_string(products.dfdx) + " and " + std::to_string(products.dfdv) + " for two");
    const Asked rhs = right_side(trial, hair, h, h).asked;
    trial.expect(
        products.forces == 0 && rhs.forces == 1 && rhs.dfdx == 1 && rhs.dfdv == 0,
        "the right-hand side takes other evaluations than one of the force and one product with df/dx",
        std::to_string(rhs.forces) + ", " + std::to_string(rhs.dfdx) + ", " + std::to_string(rhs.dfdv));
    trial.expect(step(trial, hair, h).asked.forces == 1, "a step does not take one evaluation of the force");
  }
}

// Powers of two change no rounding.
void units(Trial& trial) {
  Random& random = trial.random;
  const Cloud cloud = mixed_cloud(random, 4, Parts::all);
  const auto [a, b] = two_times(random);
  const VectorXd x = random_vector(random, 12), product = multiply(trial, cloud, a, b, x).product,
                 rhs = right_side(trial, cloud, a, b).rhs;
  for (const double mass : {0x1p-40, 0x1p40})
    for (const double length : {0x1p-40, 0x1p40}) {
      const Cloud other = in_other_units(cloud, mass, length);
      trial.expect_close({multiply(trial, cloud, a, b, length * x).product / length, product},
                         1e-9 * product.norm(), "how much a product changes in another unit of length");
      trial.expect_close({right_side(trial, other, a, b).rhs / (mass * length), rhs}, 1e-9 * rhs.norm(),
                         "how much the right-hand side changes in other units of mass and length");
    }
  expect_same_solve_in_other_units(trial);
}

}  // namespace grader::h4
