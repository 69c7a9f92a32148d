// STAFF ONLY. H2: hidden cases of special joints: clamped, nearly straight, folded, without a direction,
// tiny, huge. Most compare the student's answers with each other, so that a mistake elsewhere does not count
// again.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "hair/angular_springs.h"
#include "reference/H2/joints.h"

namespace grader::h2 {
namespace {

using Eigen::Vector3d;

// A joint between segments of 1 m, bent by phi in the plane of two directions that are drawn.
struct Plane {
  Strand strand;
  Vector3d along, across;

  explicit Plane(Random& random)
      : strand(even_strand(random, 3)),
        along(checks::ordinary_direction(random)),
        across(along.cross(checks::ordinary_direction(random)).normalized()) {}

  Posed bent_by(double phi) const {
    Posed posed{strand, VectorXd::Zero(9), "one joint, bent by " + std::to_string(phi)};
    posed.x.segment<3>(3) = along;
    posed.x.segment<3>(6) = along + std::cos(phi) * along + std::sin(phi) * across;
    return posed;
  }
};

// The force on the tip, as a multiple of the reference's.
double tip_share(Trial& trial, const Posed& posed) {
  const VectorXd f = ask_force(trial, posed).tail<3>(), expected = reference_force(posed).tail<3>();
  return f.dot(expected) / expected.squaredNorm();
}

}  // namespace

// The root's joint is like one between two segments whose first one does not move, but twice as stiff. The
// student's own answers to both are compared, so that a mistake elsewhere does not count again.
void clamped_root(Trial& trial) {
  Random& random = trial.random;
  Strand clamped = even_strand(random, 2);
  clamped.clamped = true;
  clamped.root_tangent = checks::ordinary_direction(random);
  const Posed root = random_pose(random, clamped, kStretch, {0.3, 1.4}, "clamped, one segment");
  Posed free{even_strand(random, 3), VectorXd(9), "free, two segments"};
  free.strand.bend_rigidity = clamped.bend_rigidity;
  free.x << root.x.head<3>() - clamped.root_tangent, root.x;

  const double E = ask_energy(trial, free);
  expect_size(trial, E, hair::bend_energy(free.strand, free.x), "the energy");
  // The first segment's direction is rounded in the free strand, by u |x|.
  const double shift = 64 * kUnit * (1 + largest(root.x));
  const double k = 2 * clamped.bend_rigidity, arm = (root.x.tail<3>() - root.x.head<3>()).norm();
  trial.expect_at_most(std::abs(ask_energy(trial, root) - 2 * E), 8 * energy_rounding(root) + k * 4 * shift,
                       "the error of a clamped root's energy");
  const VectorXd f = ask_force(trial, free), at_root = ask_force(trial, root);
  expect_size(trial, f.tail<3>().norm(), reference_force(free).tail<3>().norm(), "the force");
  // The root has the reaction, if inner joints are balanced.
  const auto expect_twice = [&](const VectorXd& answer, const VectorXd& of_free, double rounding,
                                const std::string& what) {
    VectorXd expected = answer;
    expected.tail<3>() = 2 * of_free.tail<3>();
    if (is_balanced(of_free, rounding)) expected.head<3>() = -expected.tail<3>();
    expect_vector(trial, answer, expected, rounding, what);
  };
  expect_twice(at_root, f, 8 * force_rounding(root) + k / arm * 4 * shift, "a clamped root's force");
  for (int function : {kProduct, kSpdProduct}) {
    VectorXd dx = VectorXd::Zero(6), moved = VectorXd::Zero(9);
    dx.tail<3>() = moved.tail<3>() = random_vector(random, 3);
    const VectorXd df = ask_product(trial, free, moved, function);
    expect_size(trial, df.tail<3>().norm(), reference_product(free, moved, function).tail<3>().norm(),
                "the product");
    expect_twice(ask_product(trial, root, dx, function), df,
                 8 * product_rounding(root, dx) + k / (arm * arm) * 64 * shift * largest(dx),
                 "a clamped root's product");
  }

  // In a longer strand the clamp adds the root's joint and nothing else.
  Strand strand = checks::ordinary_strand(random, 6);
  strand.clamped = true;
  Posed with = random_pose(random, strand, kStretch, {0.3, 1.4}, "clamped"), without = with;
  const Posed alone = part_of(with, 0, 2);
  without.strand.clamped = false;
  without.name = "the same, not clamped";
  VectorXd sum = ask_force(trial, without);
  sum.head<6>() += ask_force(trial, alone);
  expect_vector(trial, ask_force(trial, with), sum, 4 * force_rounding(with),
                "what a clamped root adds to the force");
  const VectorXd dx = random_vector(random, with.x.size());
  for (int function : {kProduct, kSpdProduct}) {
    sum = ask_product(trial, without, dx, function);
    sum.head<6>() += ask_product(trial, alone, dx.head<6>(), function);
    expect_vector(trial, ask_product(trial, with, dx, function), sum, 4 * product_rounding(with, dx),
                  "what a clamped root adds to the product");
  }
}

// Bends are 1e-2 to 1e-9, where acos(cos(phi)) has lost its digits. They are compared with a larger bend,
// since a wrong constant is for another category.
void nearly_straight(Trial& trial) {
  Random& random = trial.random;
  const Plane plane(random);
  const Posed base = plane.bent_by(0.5);
  const double E = ask_energy(trial, base) / hair::bend_energy(base.strand, base.x),
               tip = tip_share(trial, base);
  expect_size(trial, std::abs(E), 1, "the energy");
  expect_size(trial, std::abs(tip), 1, "the force");
  for (double bend : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-9}) {
    const Posed posed = plane.bent_by(bend);
    // phi is known to a few u.
    const double rounding = 256 * kUnit / bend;
    trial.expect_at_most(
        std::abs(ask_energy(trial, posed) / hair::bend_energy(posed.strand, posed.x) / E - 1), rounding,
        "the relative error of the energy at a small bend, compared with your own at a larger bend,");
    trial.expect_at_most(
        std::abs(tip_share(trial, posed) / tip - 1), rounding,
        "the relative error of the force at a small bend, compared with your own at a larger bend,");
  }
  // One strand is straight to the last bit, another one up to rounding.
  for (const Vector3d& direction :
       {Vector3d(0, 0, -1), Vector3d(0, 1, 0), checks::ordinary_direction(random)}) {
    const Strand strand = even_strand(random, 8);
    const Posed posed = straight_pose(strand, strand.rest_length, direction, "straight");
    trial.expect_at_most(std::abs(ask_energy(trial, posed)), 4 * energy_rounding(posed),
                         "a straight strand's energy");
    // Both phi and u2 - cos(phi) u1 are roundings of 4 u, and so is the sine that some formulas divide their
    // product by, k phi (u2 - cos(phi) u1) / sin(phi): 1e-8 k, as long as it is not below 1e-7 u.
    trial.expect_at_most(largest(ask_force(trial, posed)), 1e-8 * strand.bend_rigidity,
                         "a straight strand's force");
  }
}

// Compares products with the student's own at a bend of 1e-5, where the axis is known to 1e-11. Those must be
// the same multiple of the reference's as the student's products at an ordinary bend. Products at an ordinary
// bend have another category; if they are no multiple of the reference's, nothing is compared here.
void straight_products(Trial& trial) {
  constexpr double kLittle = 1e-5;
  Random& random = trial.random;
  // Two strands are straight to the last bit; the second one's direction has few bits, and a cosine that
  // rounds to less than 1. In four others the bends are roundings, which point anywhere; some happen to be 0.
  for (int repeat = 0; repeat < 6; ++repeat) {
    const bool exactly = repeat < 2;
    const Strand strand = even_strand(random, 7);
    Vector3d direction = checks::ordinary_direction(random);
    if (repeat == 0) direction = Vector3d(0, -1, 0);
    if (repeat == 1) direction = Vector3d(-0x1.6a09ep-1, 0, 0x1.6a09ep-1);
    const Vector3d aside = checks::ordinary_direction(random);
    const Posed posed = straight_pose(strand, strand.rest_length, direction,
                                      exactly ? "straight" : "straight, rounded"),
                bent = zigzag(strand, direction, aside, kLittle),
                ordinary = zigzag(strand, direction, aside, 0.5);
    const VectorXd dx = random_vector(random, posed.x.size());
    for (int function : {kProduct, kSpdProduct}) {
      const VectorXd expected = ask_product(trial, bent, dx, function);
      expect_not_zero(trial, expected, "the product");
      // A row of the matrix sums up to 16 k / l^2, and turns with the directions, by kLittle on either side.
      // The axis of a bend phi is known to u / phi, or another axis replaces it with an error of phi: 1e-8 at
      // best, and two more digits may be lost.
      const double bound = 64 * (2 * kLittle + 1e-6) * strand.bend_rigidity * largest(dx);
      expect_vector(trial, ask_product(trial, posed, dx, function), expected, bound,
                    "the product of a straight strand, beside one that is bent by 1e-5,");
      const VectorXd own = ask_product(trial, ordinary, dx, function),
                     right = reference_product(ordinary, dx, function);
      const double share = own.dot(right) / right.squaredNorm();
      if (largest(own - share * right) <= 4 * product_rounding(ordinary, dx))
        expect_vector(trial, expected, share * reference_product(bent, dx, function),
                      std::max(1.0, std::abs(share)) * bound,
                      "the product at a bend of 1e-5, compared with your own at a larger bend,");
    }
  }
}

void no_direction(Trial& trial) {
  Random& random = trial.random;
  // There is no joint: one particle has no segment to clamp, and a clamped segment of length 0 has no angle.
  for (int kind : {0, 1, 2}) {
    const int count = kind == 0 ? 1 : 2;
    Posed posed{even_strand(random, count), random_vector(random, 3 * count), "without a joint"};
    posed.strand.clamped = kind != 1;
    if (kind == 2) posed.x.tail<3>() = Vector3d(posed.x.head<3>());
    const VectorXd dx = random_vector(random, 3 * count);
    trial.expect(ask_energy(trial, posed) == 0, "a strand without a joint has an energy");
    trial.expect(ask_force(trial, posed).isZero(0), "a strand without a joint has a force");
    trial.expect(ask_product(trial, posed, dx).isZero(0), "a strand without a joint has a product");
    trial.expect(ask_spd(trial, posed, dx).isZero(0), "a strand without a joint has a product");
  }

  // One segment, or all of them, have length 0. The parts on both sides behave as each does alone.
  for (int which : {0, 2, 5, -1}) {
    constexpr int kCount = 7;
    Posed posed = random_pose(random, even_strand(random, kCount), {1, 1}, kBend, "coincident particles");
    for (int i = 0; i + 1 < kCount; ++i)
      if (i == which || which < 0) posed.x.segment<3>(3 * i + 3) = Vector3d(posed.x.segment<3>(3 * i));
    expect_parts_alone(trial, strand_force(), posed, std::max(which, 0) + 1,
                       random_vector(random, posed.x.size()));
    trial.expect(ask_force(trial, posed).isZero(0) == (which < 0),
                 "segments of length 0 have a force, or others have none");
  }

  // A segment of length 0 has a cosine of 0, or a rounding, in some formulas.
  for (int zero : {0, 1}) {
    Posed posed{even_strand(random, 3), VectorXd::Zero(9), "two segments, one of length 0"};
    posed.x.segment<3>(6) = Vector3d(-1, -2, -2);
    if (zero == 1) posed.x.segment<3>(3) = posed.x.segment<3>(6);
    trial.expect(ask_energy(trial, posed) == 0, "a joint beside a segment of length 0 has an energy");
    trial.expect(ask_force(trial, posed).isZero(0), "a joint beside a segment of length 0 has a force");
  }
}

void fold(Trial& trial) {
  Random& random = trial.random;
  // A fold along an axis, where nothing rounds, has four times the energy of a right angle.
  Posed corner{even_strand(random, 3), VectorXd(9), "a right angle"};
  const int axis = static_cast<int>(random.integer(0, 2));
  const Vector3d along = Vector3d::Unit(axis), across = Vector3d::Unit((axis + 1) % 3);
  corner.x << Vector3d::Zero(), along, along + across;
  Posed folded = corner;
  folded.x.tail<3>().setZero();
  folded.name = "folded";
  const VectorXd dx = random_vector(random, 9);
  const double E = ask_energy(trial, corner);
  expect_size(trial, E, hair::bend_energy(corner.strand, corner.x), "the energy");
  trial.expect_at_most(std::abs(ask_energy(trial, folded) - 4 * E), 64 * kUnit * 4 * E,
                       "the error of the energy at the fold, beside a right angle's,");
  trial.expect(ask_force(trial, folded).isZero(0), "there is a force at the fold");
  trial.expect(ask_product(trial, folded, dx).isZero(0), "there is a product at the fold");
  trial.expect(ask_spd(trial, folded, dx).isZero(0), "there is a product at the fold");

  // The same holds for a clamped root that is folded back.
  Posed back{even_strand(random, 2), VectorXd::Zero(6), "a clamped root, folded"};
  back.strand.clamped = true;
  back.strand.root_tangent = along;
  back.x.tail<3>() = -along;
  trial.expect(ask_force(trial, back).isZero(0), "there is a force at the fold");
  for (int function : {kProduct, kSpdProduct})
    trial.expect(ask_product(trial, back, dx.head<6>(), function).isZero(0),
                 "there is a product at the fold");

  // Next to the fold the force is finite, and in proportion to the angle as at a right angle.
  const Plane plane(random);
  const double tip = tip_share(trial, plane.bent_by(1.5));
  expect_size(trial, std::abs(tip), 1, "the force");
  for (double missing : {1e-2, 1e-4, 1e-6})
    trial.expect_at_most(std::abs(tip_share(trial, plane.bent_by(std::numbers::pi - missing)) / tip - 1),
                         256 * kUnit / missing, "the relative error of the force next to the fold");
}

}  // namespace grader::h2
