// STAFF ONLY. H8 in motion: super-helices compared with beams and the laws of energy.

#include <gtest/gtest.h>

#include <numbers>

#include "hair/lab/validate/clamped_hair.h"
#include "hair/lab/validate/elastica.h"
#include "hair/super_helix/helix_momentum.h"
#include "reference/H8/super_helices_for_tests.h"
#include "solver/dense_algebra.h"

namespace reference_tests {
namespace {

using hair::MaterialFrame;

constexpr double kHairLength = 0.1;  // m

// A level frame along x, in which kappa1 > 0 bends hair down.
MaterialFrame level() {
  MaterialFrame root;
  root.axes << Vector3d::UnitY(), Vector3d::UnitZ(), Vector3d::UnitX();
  return root;
}

// ---- Small oscillations of a straight beam: K v = omega^2 M v for kappa1. Rayleigh and Ritz: every
// frequency is too high, and comes down by order 2 of the elements' length (in omega^2).
TEST(SuperHelixOscillations, HaveABeamsFrequencies) {
  std::vector<double> before(4, 0);
  for (const int elements : {5, 10, 20, 40}) {
    HelixMotion motion(hair_strand(elements, kHairLength));
    const HelixStrand& strand = motion.strand();
    motion.place({}, VectorXd::Zero(3 * elements));
    MatrixXd M(3 * elements, 3 * elements);
    hair::mass_matrix(motion.elements, motion.points, M);
    MatrixXd bending(elements, elements);
    for (int i = 0; i < elements; ++i)
      for (int k = 0; k < elements; ++k) bending(i, k) = M(3 * i, 3 * k);
    // K is a number here, EI l, so M's eigenvalues are K / omega^2, with the largest first.
    const VectorXd inverse =
        solver::symmetric_eigenvalues(bending).reverse() / (strand.bend_rigidity * strand.lengths[0]);
    for (int mode = 0; mode < (elements == 5 ? 3 : 4); ++mode) {
      const double square = std::pow(hair::clamped_beam_root(mode + 1) / kHairLength, 4) *
                            strand.bend_rigidity / strand.line_density;
      const double error = 1 / (inverse[mode] * square) - 1;
      EXPECT_GT(error, 0) << "mode " << mode << ", " << elements << " elements";
      if (before[mode] > 0) {
        EXPECT_NEAR(std::log2(before[mode] / error), 2, 0.35) << "mode " << mode << ", " << elements;
      }
      before[mode] = error;
    }
  }
}

// ---- Motion

struct Moving {
  HelixMotion motion;
  hair::HelixMomentum momentum;
  VectorXd q, rates;
  HelixRoot root;
  Vector3d gravity = Vector3d::Zero();
  double drag = 0;

  explicit Moving(const HelixStrand& strand)
      : motion(strand), q(strand.natural), rates(VectorXd::Zero(q.size())) {}

  void step(double h) {
    motion.place(root.frame, q);
    motion.move(root, rates);
    momentum.add_to(motion, h);
    hair::add_weight(gravity, motion);
    hair::add_drag(drag, Vector3d::Zero(), h, motion);
    MatrixXd scratch(q.size(), q.size() + 10);
    VectorXd change(q.size());
    hair::helix_step(motion.strand(), motion.elements, motion.points, q, rates, h, scratch, change);
    rates += change;
    momentum.keep(motion, root, rates);
    q += h * rates;
  }

  double energy() {
    motion.place(root.frame, q);
    motion.move(root, rates);
    return hair::elastic_energy(motion.strand(), q) + hair::weight_energy(gravity, motion) +
           hair::kinetic_energy(motion);
  }
};

// The force from momenta tends to A with h, to first order: half the step makes half the difference.
TEST(SuperHelixMotion, MomentaAreAForShortSteps) {
  double before = 0;
  for (const double h : {4e-6, 2e-6, 1e-6}) {
    RandomNumbers numbers(12);
    HelixMotion motion(hair_strand(4, kHairLength));
    const HelixRoot root = random_root(numbers);
    const VectorXd q = random_curl(motion.strand(), 3, numbers),
                   rates = random_curl(motion.strand(), 20, numbers);
    HelixRoot earlier = root;
    earlier.frame.position -= h * root.velocity;
    earlier.frame.axes = Eigen::AngleAxisd(-h * root.spin.norm(), root.spin.normalized()) * root.frame.axes;
    earlier.velocity -= h * root.acceleration;
    earlier.spin -= h * root.spin_acceleration;
    hair::HelixMomentum momentum;
    motion.place(earlier.frame, q - h * rates);
    momentum.keep(motion, earlier, rates);
    motion.place(root.frame, q);
    motion.move(root, rates);
    motion.accelerate(root, rates);
    momentum.add_to(motion, h);
    double difference = 0, size = 0;
    for (std::size_t j = 0; j < motion.points.size(); ++j) {
      const Vector3d exact = -motion.points[j].inertia * motion.accelerations[j];
      difference = std::max(difference, (motion.points[j].force - exact).norm());
      size = std::max(size, exact.norm());
    }
    if (before > 0) {
      EXPECT_NEAR(before / difference, 2, 0.1) << "h = " << h;
    }
    EXPECT_LT(difference, 0.05 * size) << "h = " << h;
    before = difference;
  }
}

// Without weight and drag the sum of elastic energy and of kinetic energy (at the step's beginning) never
// grows, for any h: the projection does not add to the kept velocities' energy, and springs at the end of a
// step give no more than they lose.
TEST(SuperHelixMotion, NeverGainsEnergyWithoutForces) {
  for (const double h : {1e-4, 1e-3, 1.0 / 30}) {
    RandomNumbers numbers(13);
    const HelixStrand strand = hair_strand(6, kHairLength, Vector3d(50, 0, 80));
    Moving whirling(strand);
    whirling.q = random_curl(strand, 6, numbers);
    whirling.rates = random_curl(strand, 300, numbers);
    double before = whirling.energy();
    int grown = 0;
    for (int k = 0; k < 200; ++k) {
      whirling.step(h);
      whirling.motion.move(whirling.root, whirling.rates);  // still where the step began
      const double energy = hair::elastic_energy(strand, whirling.q) + hair::kinetic_energy(whirling.motion);
      grown += energy > before * (1 + 1e-9);
      before = energy;
    }
    EXPECT_EQ(grown, 0) << "steps of 200, h = " << h;
  }
}

// A level curl is let go. The step takes elastic forces at its end, and projects, so it loses energy, by
// order 1 of h.
TEST(SuperHelixMotion, LosesEnergyToTheFirstOrder) {
  double losses[3];
  int k = 0;
  for (const double h : {4e-5, 2e-5, 1e-5}) {
    Moving curl(hair_strand(4, kHairLength, Vector3d(60, 0, 30)));
    curl.root.frame = level();
    curl.gravity = Vector3d(0, 0, -9.81);
    const double start = curl.energy();
    double kinetic = 0;
    for (double t = 0; t < 0.1; t += h) {
      curl.step(h);
      kinetic = std::max(kinetic, hair::kinetic_energy(curl.motion));
    }
    losses[k++] = (start - curl.energy()) / kinetic;
  }
  EXPECT_NEAR(losses[1] / losses[2], 2, 0.3);
  EXPECT_GT(losses[2], 0);
  EXPECT_LT(losses[2], 0.02);
}

// Extremes together, for 4 s in steps of 1/30 s, without drag and with the air's. Weight is explicit, so the
// tension of long hair may pump energy into it if nothing removes it. The energy stays bounded, and with the
// air's drag hair gains nothing.
TEST(SuperHelixMotion, HoldsInExtremes) {
  struct Extreme {
    const char* name;
    int elements;
    double length, turns;  // m, of natural curl in each element
  };
  for (const Extreme& e :
       {Extreme{"20 turns in each of 5 elements", 5, 0.1, 20},
        Extreme{"20 turns in each of 20 elements", 20, 0.5, 20}, Extreme{"straight, Gamma 7e3", 20, 1, 0},
        Extreme{"straight, Gamma 1e7", 20, 11.4, 0}, Extreme{"a short stiff hair", 40, 0.01, 0}})
    for (const double drag : {0.0, 1e-4}) {
      Moving hair(
          hair_strand(e.elements, e.length,
                      2 * std::numbers::pi * e.turns * e.elements / e.length * Vector3d(0.6, 0, 0.8)));
      hair.root.frame = level();
      hair.gravity = Vector3d(0, 0, -9.81);
      hair.drag = drag;
      const double start = hair.energy(), weight = hair.motion.strand().line_density * e.length * 9.81;
      double most = 0;
      for (int k = 0; k < 120; ++k) {
        hair.step(1.0 / 30);
        const double gained = (hair.energy() - start) / (weight * e.length);
        ASSERT_TRUE(std::isfinite(gained)) << e.name << ", step " << k;
        most = std::max(most, gained);
      }
      EXPECT_LE(most, drag > 0 ? 1e-9 : 200) << e.name << ", drag " << drag;
    }
}

}  // namespace
}  // namespace reference_tests
