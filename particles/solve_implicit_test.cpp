// STAFF ONLY. The promises of particles/solve_implicit.h, with the reference's H4 and S1. Retries of plain
// solves: reference/H6/predictor_corrector_test.cpp.
#include "particles/solve_implicit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "particles/products_to_band.h"
#include "particles/springs.h"

namespace particles {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

constexpr double kStep = 1.0 / 60;

// Springs whose band contains only those between neighbours.
class NearSprings final : public DampedSprings {
 public:
  explicit NearSprings(const std::vector<Spring>& springs, Products products = Products::definite)
      : DampedSprings(springs, products), near_(near(springs), products) {}
  bool add_band(Input x, Input v, double by_dfdx, double, solver::BlockBand& band,
                Scratch work) const override {
    return add_products(
        2, by_dfdx, [&](Input dx, Output df) { near_.add_dfdx(x, v, dx, df); }, band, work);
  }

 private:
  static std::vector<Spring> near(const std::vector<Spring>& springs) {
    std::vector<Spring> found;
    for (const Spring& spring : springs)
      if (spring.j == spring.i + 1) found.push_back(spring);
    return found;
  }
  DampedSprings near_;
};

// Particles of 1e-7 kg, 1 cm apart, the first one pinned, springs between neighbours. Each particle is a bit
// off.
struct Chain {
  Particles particles;
  State state;
  std::vector<Spring> springs;

  Chain(int n, double stiffness, double rest_length = 0.01)
      : particles{VectorXd::Constant(n, 1e-7), std::vector<char>(static_cast<std::size_t>(n), 0)},
        state{VectorXd::Zero(3 * n), VectorXd::Zero(3 * n)} {
    particles.pinned[0] = 1;
    for (int k = 3; k < 3 * n; ++k) state.x[k] = (k % 3 == 0 ? 0.01 * k / 3 : 0) + 1e-3 * std::sin(7.0 * k);
    for (int i = 1; i < n; ++i) springs.push_back({i - 1, i, stiffness, rest_length});
  }
  void tie(int reach, double stiffness) {
    for (int i = reach; i < particles.count(); ++i)
      springs.push_back({i - reach, i, stiffness, 0.01 * reach});
  }
};

struct Solved {
  SolveReport report;
  VectorXd dv;
  double left,
      rounding;  // ||rhs - A dv||, and its rounding: sums of 15 terms, and as much for their numbers
};

Solved solve(const Force& force, const Chain& chain, double tolerance) {
  const Eigen::Index size = chain.state.x.size();
  MatrixXd scratch = MatrixXd::Constant(size, kImplicitScratch, 1e3), A(size, size);
  VectorXd rhs(size), dv = VectorXd::Constant(size, 1e3);
  const auto matrix = implicit_matrix(force, chain.particles, chain.state, kStep, kStep);
  for (Eigen::Index j = 0; j < size; ++j) {
    VectorXd e = VectorXd::Unit(size, j);
    matrix->matVecMult(e.data(), A.col(j).data());
  }
  implicit_rhs(force, chain.particles, chain.state, kStep, kStep, rhs);
  const SolveReport report =
      solve_implicit(force, chain.particles, chain.state, kStep, kStep, tolerance, dv, scratch);
  EXPECT_EQ(scratch.col(kImplicitScratch - 1), VectorXd::Constant(size, 1e3)) << "the last column";
  EXPECT_NEAR(report.rhs, rhs.norm(), 1e-12 * rhs.norm());
  return {report, dv, (rhs - A * dv).norm(), 0x1p-48 * (A.norm() * dv.norm() + rhs.norm())};
}

void expect_solved(const Solved& solved, double tolerance) {
  EXPECT_TRUE(solved.report.preconditioned);
  EXPECT_TRUE(solved.report.converged) << solved.report.steps << " steps";
  EXPECT_LE(solved.left, tolerance * solved.report.rhs + solved.rounding);
  EXPECT_NEAR(solved.report.residual, solved.left, solved.rounding)
      << "the residual of dv, and not that of L^-1 r";
}

}  // namespace

TEST(SolveImplicit, TakesFewStepsWhereTheBandIsTheMatrix) {
  const Chain chain(60, 1e3);  // h^2 k/m is 2.8e6
  const Solved solved = solve(NearSprings(chain.springs), chain, 1e-10);
  expect_solved(solved, 1e-10);
  EXPECT_LE(solved.report.steps, 2 * kMostSolves);
}

TEST(SolveImplicit, SolvesAgainForWhatIsLeft) {
  Chain chain(60, 3.6);
  chain.tie(7, 1);  // as stiff as the chain, and not in the band
  for (const double tolerance : {1e-10, 1e-12})
    expect_solved(solve(NearSprings(chain.springs), chain, tolerance), tolerance);
}

TEST(SolveImplicit, HasConvergedWhereRoundingAllowsNoLess) {
  const Chain chain(60, 1e3);
  const Solved solved = solve(NearSprings(chain.springs), chain, 1e-18);
  EXPECT_TRUE(solved.report.converged) << solved.report.residual / solved.report.rhs;
  EXPECT_GT(solved.report.residual, 1e-18 * solved.report.rhs) << "else it says nothing about rounding";
}

TEST(SolveImplicit, EndsWhereTheMatrixIsNotPositiveDefinite) {
  const Chain chain(6, 1,
                    0.03);  // springs at three times their rest length, which are not in the band
  class Unknown final : public DampedSprings {
   public:
    using DampedSprings::DampedSprings;
    bool add_band(Input, Input, double, double, solver::BlockBand&, Scratch) const override { return true; }
  };
  const Solved solved = solve(Unknown(chain.springs, Products::exact), chain, 1e-10);
  EXPECT_TRUE(solved.dv.allFinite());
  EXPECT_NEAR(solved.report.residual, solved.left, solved.rounding + 1e-9 * solved.left);
  EXPECT_LE(solved.report.residual, solved.report.rhs) << "what leads farther away is not added";
}

}  // namespace particles
