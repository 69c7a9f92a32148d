// STAFF ONLY. Why the engine has no hair that is curved at rest: what steps make of a small disturbance of a wave and of a curl.
//
// With a rest curvature (hair/mass_spring/rest_curvature.h) each joint turns the frames of all joints below it, so H4's matrix is full. A band
// keeps only what joints do while their frames are held fast. Here is the largest factor by which a step multiplies a
// disturbance from rest, without gravity and drag: above 1, rest is not stable.
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdio>

#include "hair/head/bust.h"
#include "hair/head/grow.h"
#include "hair/mass_spring/rest_bend.h"
#include "hair/mass_spring/strand_start.h"
#include "reference/engine/bench/tables.h"
#include "solver/block_band.h"

namespace hair_bench {

using Eigen::MatrixXd, Eigen::VectorXd;
using hair::Vector3d;

namespace {

constexpr double kNear = 1e-7;  // m, for differences

// Forces of a strand at rest.
struct CurvedStrand {
  explicit CurvedStrand(const VectorXd& x) {
    const Vector3d tangent = (x.segment<3>(3) - x.head<3>()).normalized();
    start = start_at_rest(hair::Material{}, {x, tangent, tangent.unitOrthogonal()});
  }

  VectorXd force(const VectorXd& x, bool frames_held) const {
    const hair::StretchForce stretch(start.strand, hair::GeometricTerm::filtered);
    const hair::RestCurvature bending(start.strand, start.rest_curvature, start.root_normal,
                                      hair::Products::definite);
    VectorXd f = VectorXd::Zero(x.size());
    const VectorXd still = f;
    stretch.add_force(x, still, f);
    if (!frames_held) {
      bending.add_force(x, still, f);
      return f;
    }
    hair::rest_bend::walk<double>(
        start.strand, start.rest_curvature, start.root_normal,
        [&](int i) { return hair::rest_bend::difference(x, i); },
        [&](const hair::rest_bend::Joint<double>& joint) {
          hair::rest_bend::spread(joint, hair::rest_bend::energy_gradient(joint), 0.0, 0.0,
                                  [&](int i, const Vector3d& part) { f.segment<3>(3 * i) += part; });
        });
    return f;
  }

  // -df/dx of all points but the root, by differences.
  MatrixXd stiffness(bool frames_held) const {
    VectorXd x = start.state.x;
    const Eigen::Index n = x.size() - 3;
    MatrixXd k(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
      const double at = x[3 + j];
      x[3 + j] = at + kNear;
      k.col(j) = -force(x, frames_held).tail(n);
      x[3 + j] = at - kNear;
      k.col(j) = (k.col(j) + force(x, frames_held).tail(n)) / (2 * kNear);
      x[3 + j] = at;
    }
    return k;
  }

  // H4's matrix without the frames' turn: a band of two blocks.
  MatrixXd band() const {
    const VectorXd& x = start.state.x;
    const hair::StretchForce stretch(start.strand, hair::GeometricTerm::filtered);
    const hair::RestCurvature bending(start.strand, start.rest_curvature, start.root_normal,
                                      hair::Products::definite);
    MatrixXd memory(x.size(), solver::BlockBand::kColumns), work(x.size(), particles::kBandScratch);
    solver::BlockBand band(memory);
    band.set_zero();
    const VectorXd still = VectorXd::Zero(x.size());
    stretch.add_band(x, still, -1, 0, band, work);
    bending.add_band(x, still, -1, 0, band, work);
    MatrixXd lower = MatrixXd::Zero(x.size(), x.size());
    for (int i = 0; i < band.rows(); ++i)
      for (int back = 0; back <= std::min(2, i); ++back)
        lower.block<3, 3>(3 * i, 3 * (i - back)) = band.block(i, back);
    const MatrixXd k = lower.selfadjointView<Eigen::Lower>();
    return k.bottomRightCorner(x.size() - 3, x.size() - 3);
  }

  hair::StrandStart start;
};

// Of a step (M + h^2 k) v1 = M v - h f x, x1 = x + h v1, with f the force's stiffness and k the matrix'.
double growth(const VectorXd& mass, const MatrixXd& f, const MatrixXd& k, double h) {
  const Eigen::Index n = f.rows();
  MatrixXd matrix = h * h * k;
  for (Eigen::Index i = 0; i < n; ++i) matrix(i, i) += mass[1 + i / 3];
  const Eigen::LDLT<MatrixXd> factor(matrix);
  MatrixXd inertia = MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) inertia(i, i) = mass[1 + i / 3];
  const MatrixXd by_v = factor.solve(inertia), by_x = -h * h * factor.solve(f);
  MatrixXd step(2 * n, 2 * n);  // of x and h v
  step << MatrixXd::Identity(n, n) + by_x, by_v, by_x, by_v;
  return step.eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace

void by_curves() {
  std::printf(
      "\n| growth by a step | h, s | full matrix | band | band, and forces with frames held fast "
      "|\n|---|--:|--:|--:|--:|\n");
  for (const auto& [name, length] : {std::pair{"wavy", 0.2}, std::pair{"short-curly", 0.1}}) {
    hair::HairStyle style = *hair::find_hair_style(name);
    style.length = length;
    const CurvedStrand strand(grow_groom(hair::Bust(), style, {1, fewest_points(style), 1}).strands[0]);
    const VectorXd& mass = strand.start.strand.mass;
    const MatrixXd full = strand.stiffness(false), held = strand.stiffness(true), band = strand.band();
    for (const int per_second : {24, 60, 240, 960}) {
      const double h = 1.0 / per_second;
      std::printf("| %s | 1/%d | %.3f | %.3g | %.3f |\n", name, per_second, growth(mass, full, full, h),
                  growth(mass, full, band, h), growth(mass, held, band, h));
    }
    std::fflush(stdout);
  }
}

}  // namespace hair_bench
