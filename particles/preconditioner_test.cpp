// STAFF ONLY. The promises of particles/preconditioner.h and particles/products_to_band.h.
#include "particles/preconditioner.h"

#include <gtest/gtest.h>

#include <limits>

#include "particles/drag.h"
#include "particles/force_sum.h"
#include "particles/gravity.h"
#include "particles/products_to_band.h"
#include "particles/springs.h"
#include "solver/dense_algebra.h"
#include "solver/test_allocations.h"
#include "solver/test_numbers.h"

namespace particles {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;
using reference_tests::allocations;

using reference_tests::kUnit;

// f = -K x, where K = E' T E is that of segments e = E x, with a positive definite T that couples segments
// less than `reach` apart.
class Banded : public Force {
 public:
  Banded(int n, int reach) : reach_(reach) {
    MatrixXd T = MatrixXd::Zero(3 * n - 3, 3 * n - 3), E = MatrixXd::Zero(3 * n - 3, 3 * n);
    srand(n);
    for (int i = 0; i + 1 < n; ++i) {
      for (int j = std::max(0, i - reach + 1); j <= i; ++j) T.block<3, 3>(3 * i, 3 * j).setRandom();
      E.block<3, 3>(3 * i, 3 * i) = -Eigen::Matrix3d::Identity();
      E.block<3, 3>(3 * i, 3 * i + 3).setIdentity();
    }
    T = (T + T.transpose()).eval();
    T.diagonal().array() += 18;  // more than the 9 numbers of a row, each at most 2
    K_ = E.transpose() * T * E;
  }
  double energy(Input x) const override { return x.dot(K_ * x) / 2; }
  void add_force(Input x, Input, Output f) const override { f -= K_ * x; }
  void add_dfdx(Input, Input, Input dx, Output df) const override { df.noalias() -= K_ * dx; }
  void add_dfdv(Input, Input, Input, Output) const override {}
  bool add_band(Input x, Input v, double by_dfdx, double, solver::BlockBand& band,
                Scratch work) const override {
    return add_products(
        reach_, by_dfdx,
        [&](Input dx, Output df) {
          ++products;
          add_dfdx(x, v, dx, df);
        },
        band, work);
  }

  void add(Eigen::Index row, Eigen::Index column, double what) { K_(row, column) += what; }

  mutable int products = 0;
  const MatrixXd& stiffness() const { return K_; }

 private:
  int reach_;
  MatrixXd K_;
};

struct Case {
  explicit Case(int n) : particles{VectorXd::LinSpaced(n, 2, 5), std::vector<char>(n, 0)} {
    state = {VectorXd::LinSpaced(3 * n, -1, 1), VectorXd::LinSpaced(3 * n, 0, 1)};
    scratch.setConstant(3 * n, kPreconditionerScratch, std::numeric_limits<double>::quiet_NaN());
  }
  Preconditioner of(const Force& force) { return {force, particles, state, 0.3, 0.7, scratch}; }

  Particles particles;
  State state;
  MatrixXd scratch;
};

// The inverse of L^-T L^-1.
MatrixXd factored(const Preconditioner& preconditioner, Eigen::Index size) {
  MatrixXd inverse = MatrixXd::Identity(size, size);
  for (int i = 0; i < size; ++i) {
    preconditioner.solve_lower(inverse.col(i));
    preconditioner.solve_lower_transposed(inverse.col(i));
  }
  return solver::dense_solve(inverse, MatrixXd::Identity(size, size));
}

MatrixXd matrix_of(const solver::BlockBand& band) {
  MatrixXd A = MatrixXd::Zero(3 * band.rows(), 3 * band.rows());
  for (int i = 0; i < band.rows(); ++i)
    for (int back = 0; back <= std::min(i, 2); ++back) {
      A.block<3, 3>(3 * i, 3 * (i - back)) = band.block(i, back);
      A.block<3, 3>(3 * (i - back), 3 * i) = band.block(i, back).transpose();
    }
  return A;
}

TEST(ProductsToBand, TakesThreeProductsForEachSetOfSegmentsAndOneToTestThem) {
  for (int reach : {1, 2})
    for (int n : {1, 2, 3, 4, 11, 60}) {
      Banded force(n, reach);
      MatrixXd memory(3 * n, solver::BlockBand::kColumns), work(3 * n, kBandScratch);
      solver::BlockBand band(memory);
      band.set_zero();
      work.setConstant(std::numeric_limits<double>::quiet_NaN());
      const VectorXd x = VectorXd::Zero(3 * n);
      EXPECT_TRUE(force.add_band(x, x, -2, 0, band, work));
      EXPECT_EQ(force.products, 3 * reach + 1);
      EXPECT_LE((matrix_of(band) - 2 * force.stiffness()).norm(),
                8 * n * n * kUnit * force.stiffness().norm());
      for (const auto& [row, column] : {std::pair(0, 4), {4, 0}, {3 * n - 1, 3 * n - 2}, {3 * n - 1, 7}}) {
        Banded other(n, reach);
        if (n > 3) other.add(row, column, 1e-4);
        EXPECT_EQ(other.add_band(x, x, -2, 0, band, work), n <= 3) << row << " " << column << " of " << n;
      }
    }
}

TEST(PreconditionerTest, IsTheMatrixOfForcesWithABand) {
  for (int n : {1, 2, 3, 9})
    for (int pinned = -1; pinned < n; ++pinned) {
      Case c(n);
      if (pinned >= 0) c.particles.pinned[pinned] = 1;
      ForceSum sum;
      sum.emplace<Banded>(n, 2);
      sum.emplace<Gravity>(c.particles.mass, Vector3d(0, 0, -9.81));
      const VectorXd drag = VectorXd::LinSpaced(n, 1, 2);
      sum.emplace<Drag>(drag);
      const Preconditioner preconditioner = c.of(sum);
      ASSERT_TRUE(preconditioner.exists());

      MatrixXd A = 0.3 * 0.7 * Banded(n, 2).stiffness();
      for (int i = 0; i < 3 * n; ++i) A(i, i) += c.particles.mass[i / 3] + 0.3 * drag[i / 3];
      if (pinned >= 0) {
        A.middleRows<3>(3 * pinned).setZero();
        A.middleCols<3>(3 * pinned).setZero();
      }
      EXPECT_NEAR(preconditioner.norm(), A.cwiseAbs().rowwise().sum().maxCoeff(), 1e-13 * A.norm())
          << "without the 1 of a pinned particle";
      if (pinned >= 0) A.block<3, 3>(3 * pinned, 3 * pinned).setIdentity();
      const MatrixXd error = factored(preconditioner, 3 * n) - A;
      EXPECT_LE(error.norm(), 1e3 * kUnit * A.norm()) << "of numbers from 1 to 50";
    }
}

TEST(PreconditionerTest, DoesNotExistWithoutABandOrADefiniteMatrix) {
  Case c(3);
  ForceSum sum;
  sum.emplace<Banded>(3, 1);
  EXPECT_TRUE(c.of(sum).exists());
  sum.emplace<DampedSprings>(std::vector<Spring>{{0, 1, 1, 1}});
  EXPECT_FALSE(c.of(sum).exists()) << "springs between any two particles";

  ForceSum hidden;
  hidden.emplace<Banded>(3, 1);
  hidden.hide_band();
  EXPECT_FALSE(c.of(hidden).exists());

  Banded unsymmetric(3, 1);
  unsymmetric.add(0, 4, 0.1);
  EXPECT_FALSE(c.of(unsymmetric).exists());

  const Banded force(3, 1);
  EXPECT_FALSE(Preconditioner(force, c.particles, c.state, 10, -10, c.scratch).exists()) << "indefinite";
  c.particles.mass[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(c.of(force).exists());
}

TEST(PreconditionerTest, AllocatesNothing) {
  Case c(9);
  const Banded force(9, 2);
  VectorXd x = VectorXd::Ones(27);
  c.of(force);
  const long before = allocations();
  ASSERT_GT(before, 0) << "nothing is counted";
  const Preconditioner preconditioner = c.of(force);
  preconditioner.solve_lower(x);
  preconditioner.solve_lower_transposed(x);
  EXPECT_EQ(allocations(), before);
}

// A = 2 M: L^-1 A L^-T is twice the identity.
TEST(PreconditionedMatrixTest, IsNearTheIdentity) {
  Case c(7);
  const Banded force(7, 2);
  const Preconditioner preconditioner = c.of(force);
  class Twice : public implicitMatrix {
   public:
    explicit Twice(MatrixXd M) : M_(std::move(M)) {}
    void matVecMult(double x[], double b[]) override {
      Eigen::Map<VectorXd>(b, M_.rows()) = 2 * M_ * Eigen::Map<const VectorXd>(x, M_.rows());
    }

   private:
    MatrixXd M_;
  } A(factored(preconditioner, 21));
  VectorXd work(21), x = VectorXd::LinSpaced(21, -1, 3), b(21);
  const VectorXd before = x;
  PreconditionedMatrix near_identity(A, preconditioner, work);
  near_identity.matVecMult(x.data(), b.data());
  EXPECT_LE((b - 2 * x).norm(), 1e4 * kUnit * x.norm());
  EXPECT_EQ(x, before);
}

}  // namespace
}  // namespace particles
