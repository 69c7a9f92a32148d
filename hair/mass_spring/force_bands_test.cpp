// STAFF ONLY. Compares the bands of a strand's forces with their own products.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "hair/mass_spring/strand_forces.h"
#include "hair/mass_spring/test_rest_curvature_cases.h"
#include "solver/block_band.h"

namespace hair {
namespace {

MatrixXd band_of(const particles::Force& force, const VectorXd& x) {
  const Eigen::Index size = x.size();
  MatrixXd memory(size, solver::BlockBand::kColumns), work(size, particles::kBandScratch);
  solver::BlockBand band(memory);
  band.set_zero();
  EXPECT_TRUE(force.add_band(x, VectorXd::Zero(size), -1, 0, band, work));
  MatrixXd A = MatrixXd::Zero(size, size);
  for (int i = 0; i < band.rows(); ++i)
    for (int back = 0; back <= std::min(i, 2); ++back) {
      A.block<3, 3>(3 * i, 3 * (i - back)) = band.block(i, back);
      A.block<3, 3>(3 * (i - back), 3 * i) = band.block(i, back).transpose();
    }
  return A;
}

MatrixXd products_of(const particles::Force& force, const VectorXd& x) {
  return -reference_tests::matrix_of([&](const VectorXd& dx) { return product_of(force, x, dx); }, x.size());
}

TEST(ForceBands, AreTheDefiniteProductsOfSprings) {
  for (const StrandState& s : clamped_states()) {
    SCOPED_TRACE(s.name);
    const auto expect_same = [&](const particles::Force& force, const particles::Force& definite) {
      const MatrixXd expected = products_of(definite, s.x);
      EXPECT_LE((band_of(force, s.x) - expected).norm(), 64 * kUnit * expected.norm());
    };
    using enum GeometricTerm;
    for (GeometricTerm term : {full, filtered, dropped}) {
      const GeometricTerm near = term == full ? filtered : term;
      expect_same(StretchForce(s.strand, term), StretchForce(s.strand, near));
      expect_same(BendSpringForce(s.strand, term), BendSpringForce(s.strand, near));
    }
    for (Products products : {Products::exact, Products::definite})
      expect_same(BendForce(s.strand, products), BendForce(s.strand, Products::definite));
  }
}

TEST(ForceBands, OfRestCurvatureAreNeverNegative) {
  for (const StrandState& s : clamped_states()) {
    SCOPED_TRACE(s.name + ", " + std::to_string(s.strand.count()) + " particles");
    const RestCurvature curved(s.strand, some_rest(s.strand), some_normal(s.strand.root_tangent),
                               Products::definite);
    const MatrixXd band = band_of(curved, s.x);
    EXPECT_GE(Eigen::SelfAdjointEigenSolver<MatrixXd>(band).eigenvalues()[0], -64 * kUnit * band.norm());
  }
}

// A frame turns about the strand by tan(phi/2), so only the last joint may bend: then the local product is
// exact.
TEST(ForceBands, OfRestCurvatureAreItsProductsWhereNoFrameTurns) {
  for (double angle : {0.0, 0.4, 1.2, 1.8, 2.6}) {
    Strand strand;
    strand.mass = VectorXd::Ones(6);
    strand.rest_length = VectorXd::LinSpaced(5, 0.01, 0.02);
    strand.bend_rigidity = 1e-9;
    strand.clamped = true;
    strand.root_tangent = Vector3d::UnitX();
    VectorXd x = VectorXd::Zero(18);
    for (int i = 0; i < 5; ++i) {
      const Vector3d along =
          i < 4 ? Vector3d::UnitX() : Vector3d(cos(angle), 0.6 * sin(angle), 0.8 * sin(angle));
      x.segment<3>(3 * i + 3) = x.segment<3>(3 * i) + 1.1 * strand.rest_length[i] * along;
    }
    const RestCurvature force(strand, some_rest(strand), Vector3d::UnitY(), Products::definite);
    const MatrixXd products = products_of(force, x);
    EXPECT_LE((band_of(force, x) - products).norm(), 256 * kUnit * products.norm()) << angle;
  }
}

}  // namespace
}  // namespace hair
