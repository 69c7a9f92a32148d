// STAFF ONLY. H2: hidden cases of bend_energy, add_bend_force and the two products. Bounds: h2_joints.h.
#include "grader/suite/h2_categories.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "grader/suite/h2_joints.h"
#include "hair/angular_springs.h"

namespace grader::h2 {
namespace {

using Eigen::Vector3d;

constexpr Range kStretch = {0.6, 1.5}, kBend = {0.1, 2.8};

void expect_energy(Trial& trial, const Posed& posed) {
  trial.expect_at_most(std::abs(ask_energy(trial, posed) - hair::bend_energy(posed.strand, posed.x)),
                       energy_rounding(posed), "the error of the energy");
}

VectorXd reference_force(const Posed& posed) {
  VectorXd f = VectorXd::Zero(posed.x.size());
  hair::add_bend_force(posed.strand, posed.x, f);
  return f;
}

void expect_force(Trial& trial, const Posed& posed) {
  expect_vector(trial, ask_force(trial, posed), reference_force(posed), force_rounding(posed), "the force");
}

VectorXd ask_spd(Trial& trial, const Posed& posed, const VectorXd& dx) {
  return ask_product(trial, posed, dx, GeometricTerm::full, kSpdProduct);
}

VectorXd reference_product(const Posed& posed, const VectorXd& dx, int function) {
  VectorXd df = VectorXd::Zero(dx.size());
  (function == kProduct ? hair::add_bend_product : hair::add_bend_product_spd)(posed.strand, posed.x, dx, df);
  return df;
}

void expect_product(Trial& trial, const Posed& posed, int function, double rounding_of_straight = 0) {
  const VectorXd dx = random_vector(trial.random, posed.x.size());
  const VectorXd df = ask_product(trial, posed, dx, GeometricTerm::full, function);
  expect_vector(trial, df, reference_product(posed, dx, function),
                product_rounding(posed, dx) + rounding_of_straight * largest(dx), "the product");
}

void energy(Trial& trial) {
  Random& random = trial.random;
  for (int count : {3, 4, 10, 50})
    expect_energy(trial, random_pose(random, toy_strand(random, count), kStretch, kBend, "bent"));
  expect_energy(trial, random_pose(random, toy_strand(random, 12), {1, 1}, {0.02, 0.3}, "bent a little"));
}

void single_joint(Trial& trial) {
  Random& random = trial.random;
  for (Range bend : {Range{0.1, 1}, Range{1, 1.5}, Range{1.6, 2.8}})
    for (int repeat = 0; repeat < 2; ++repeat)
      expect_force(trial, random_pose(random, toy_strand(random, 3), kStretch, bend, "one joint"));
}

void strand_forces(Trial& trial) {
  Random& random = trial.random;
  for (int count : {4, 5, 20})
    expect_force(trial, random_pose(random, toy_strand(random, count), kStretch, kBend, "bent"));
  expect_force(trial,
               random_pose(random, toy_strand(random, 8), {0.01, 0.011}, {0.1, 1}, "compressed to 1 %"));
  expect_force(trial, random_pose(random, toy_strand(random, 10000), {1, 1}, {0.05, 0.3}, "long"));
}

void balance(Trial& trial) {
  Random& random = trial.random;
  for (int count : {3, 6, 25}) {
    const Posed posed = random_pose(random, toy_strand(random, count), kStretch, kBend, "bent");
    const VectorXd f = ask_force(trial, posed);
    expect_size(trial, f.norm(), reference_force(posed).norm(), "the force");
    Vector3d sum = Vector3d::Zero(), torque = Vector3d::Zero();
    for (int i = 0; i < count; ++i) {
      const Vector3d here = f.segment<3>(3 * i);
      sum += here;
      torque += Vector3d(posed.x.segment<3>(3 * i)).cross(here);
    }
    const double rounding = count * (force_rounding(posed) + kUnit * largest(f));
    trial.expect_at_most(sum.norm(), rounding, "the sum of all forces");
    trial.expect_at_most(torque.norm(), 2 * rounding * largest(posed.x), "the sum of all torques");
  }
}

// The root's joint is like one between two segments, of which the first does not move, but twice as stiff: the
// student's own answers to both, so that a mistake elsewhere does not count again.
void clamped_root(Trial& trial) {
  Random& random = trial.random;
  Strand clamped = toy_strand(random, 2);
  clamped.clamped = true;
  clamped.root_tangent = random_direction(random);
  const Posed root = random_pose(random, clamped, kStretch, {0.3, 1.4}, "clamped, one segment");
  Posed free{toy_strand(random, 3), VectorXd(9), "free, two segments"};
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
  VectorXd expected(6);
  expected << -2 * f.tail<3>(), 2 * f.tail<3>();
  expect_vector(trial, at_root, expected, 8 * force_rounding(root) + k / arm * 4 * shift,
                "a clamped root's force");
  for (int function : {kProduct, kSpdProduct}) {
    VectorXd dx = VectorXd::Zero(6), moved = VectorXd::Zero(9);
    dx.tail<3>() = moved.tail<3>() = random_vector(random, 3);
    const VectorXd df = ask_product(trial, free, moved, GeometricTerm::full, function);
    expect_size(trial, df.tail<3>().norm(), reference_product(free, moved, function).tail<3>().norm(),
                "the product");
    expected << -2 * df.tail<3>(), 2 * df.tail<3>();
    expect_vector(trial, ask_product(trial, root, dx, GeometricTerm::full, function), expected,
                  8 * product_rounding(root, dx) + k / (arm * arm) * 64 * shift * largest(dx),
                  "a clamped root's product");
  }

  // A longer strand: what the clamp adds is the root's joint.
  Strand strand = toy_strand(random, 6);
  strand.clamped = true;
  strand.root_tangent = clamped.root_tangent;
  Posed with = random_pose(random, strand, kStretch, {0.3, 1.4}, "clamped"), without = with, alone = with;
  without.strand.clamped = false;
  without.name = "the same, not clamped";
  alone.strand.mass.conservativeResize(2);
  alone.strand.rest_length.conservativeResize(1);
  alone.x.conservativeResize(6);
  alone.name = "its first segment alone";
  VectorXd sum = ask_force(trial, without);
  sum.head<6>() += ask_force(trial, alone);
  expect_vector(trial, ask_force(trial, with), sum, 4 * force_rounding(with),
                "what a clamped root adds to the force");
}

// A joint between segments of 1 m, bent by phi in the plane of two directions that are drawn.
struct Plane {
  Strand strand;
  Vector3d along, across;

  explicit Plane(Random& random)
      : strand(toy_strand(random, 3)),
        along(random_direction(random)),
        across(along.cross(random_direction(random)).normalized()) {}

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

// Bends of 1e-2 to 1e-9, where acos(cos(phi)) has lost its digits. What counts is that they are right beside a larger
// bend: a constant that is wrong is another category's.
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
        "the relative error of a small bend's energy, beside a larger one's,");
    trial.expect_at_most(std::abs(tip_share(trial, posed) / tip - 1), rounding,
                         "the relative error of a small bend's force, beside a larger one's,");
  }
  // Straight: to the last bit, and as far as numbers go.
  for (const Vector3d& direction : {Vector3d(0, 0, -1), Vector3d(0, 1, 0), random_direction(random)}) {
    const Strand strand = toy_strand(random, 8);
    const Posed posed = straight_pose(strand, strand.rest_length, direction, "straight");
    trial.expect_at_most(std::abs(ask_energy(trial, posed)), 4 * energy_rounding(posed),
                         "a straight strand's energy");
    trial.expect_at_most(largest(ask_force(trial, posed)), force_rounding(posed),
                         "a straight strand's force");
  }
}

void straight_products(Trial& trial) {
  Random& random = trial.random;
  for (bool exactly : {true, false}) {
    const Strand strand = toy_strand(random, 7);
    const Vector3d direction = exactly ? Vector3d(0, -1, 0) : random_direction(random);
    const Posed posed =
        straight_pose(strand, strand.rest_length, direction, exactly ? "straight" : "straight, rounded");
    // The axis of a bend phi is known to u / phi, or replaced by another at the price of phi: at best 1e-8 of k / l^2
    // for a program that does no better than to choose. It may lose two digits more.
    for (int function : {kProduct, kSpdProduct})
      expect_product(trial, posed, function, 64 * 1e-6 * strand.bend_rigidity);
  }
}

void lost_directions(Trial& trial) {
  Random& random = trial.random;
  for (int count : {1, 2}) {
    const Posed posed{toy_strand(random, count), random_vector(random, 3 * count), "without a joint"};
    const VectorXd dx = random_vector(random, 3 * count);
    trial.expect(ask_energy(trial, posed) == 0, "a strand without a joint has an energy");
    trial.expect(ask_force(trial, posed).isZero(0), "a strand without a joint has a force");
    trial.expect(ask_product(trial, posed, dx).isZero(0), "a strand without a joint has a product");
    trial.expect(ask_spd(trial, posed, dx).isZero(0), "a strand without a joint has a product");
  }

  // Coincident particles. What the other segments give is another category's.
  for (int which : {0, 2, 5, -1}) {
    Posed posed = random_pose(random, toy_strand(random, 7), kStretch, kBend, "coincident particles");
    for (int i = 0; i < 6; ++i)
      if (i == which || which < 0) posed.x.segment<3>(3 * i + 3) = posed.x.segment<3>(3 * i);
    const bool nothing = which < 0;
    const VectorXd dx = random_vector(random, posed.x.size());
    trial.expect((ask_energy(trial, posed) == 0) == nothing,
                 "segments of length 0 have an energy, or others none");
    trial.expect(ask_force(trial, posed).isZero(0) == nothing,
                 "segments of length 0 have a force, or others none");
    trial.expect(ask_product(trial, posed, dx).isZero(0) == nothing,
                 "segments of length 0 have a product, or others none");
    trial.expect(ask_spd(trial, posed, dx).isZero(0) == nothing,
                 "segments of length 0 have a product, or others none");
  }

  // Folded, along an axis, so that nothing rounds: four times the energy of a right angle.
  Posed corner{toy_strand(random, 3), VectorXd(9), "a right angle"};
  corner.x << 0, 0, 0, 0, 1, 0, 0, 1, 1;
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

  // Next to it the force is finite: as at a right angle, with the angle in proportion.
  const Plane plane(random);
  const double tip = tip_share(trial, plane.bent_by(1.5));
  expect_size(trial, std::abs(tip), 1, "the force");
  for (double missing : {1e-2, 1e-4, 1e-6})
    trial.expect_at_most(std::abs(tip_share(trial, plane.bent_by(std::numbers::pi - missing)) / tip - 1),
                         256 * kUnit / missing, "the relative error of the force next to the fold");
}

void exact_product(Trial& trial) {
  Random& random = trial.random;
  for (int count : {3, 3, 4, 20})
    expect_product(trial, random_pose(random, toy_strand(random, count), kStretch, kBend, "bent"), kProduct);
  expect_product(trial, random_pose(random, toy_strand(random, 10), kStretch, {0.02, 0.3}, "bent a little"),
                 kProduct);
}

void spd_product(Trial& trial) {
  Random& random = trial.random;
  for (int count : {3, 3, 4, 20}) {
    for (Range bend : {Range{0.1, 1.4}, Range{1.7, 2.8}}) {
      const Posed posed = random_pose(random, toy_strand(random, count), kStretch, bend, "bent");
      expect_product(trial, posed, kSpdProduct);
      const VectorXd dx = random_vector(random, posed.x.size());
      trial.expect_at_most(dx.dot(ask_spd(trial, posed, dx)), product_rounding(posed, dx) * dx.lpNorm<1>(),
                           "dx . df, which for a semi-definite S is never positive,");
    }
  }
}

// Properties of the student's own answers: a mistake elsewhere does not count again.
void sampling(Trial& trial) {
  Random& random = trial.random;
  // The lecture's circle, in n segments of length 2 pi R / n, which meet at n - 1 joints.
  const double EI = random.uniform(2, 7), R = random.uniform(0.05, 0.4);
  std::vector<double> energies;
  for (int n : {8, 16, 32, 64}) {
    Strand strand = toy_strand(random, n + 1);
    strand.bend_rigidity = EI;
    strand.rest_length.setConstant(2 * std::numbers::pi * R / n);
    Posed circle{strand, VectorXd::Zero(3 * n + 3), "circle"};
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      circle.x.segment<3>(3 * i + 3) =
          circle.x.segment<3>(3 * i) + strand.rest_length[i] * Vector3d(std::cos(angle), 0, std::sin(angle));
    }
    energies.push_back(ask_energy(trial, circle) * n / (n - 1));
  }
  expect_size(trial, energies[0], std::numbers::pi * EI / R, "the energy");
  // Points of the circle round by u of its diameter, angles by u n: relative to themselves by u n^2.
  expect_all_equal(trial, energies, 16 * kUnit * 64 * 64,
                   "how the circle's energy changes with the number of segments");

  // One joint between segments that differ, at the same angle: E (l1 + l2) is the same.
  const Vector3d along(0, 0, -1), bent(0, std::sin(0.7), -std::cos(0.7));
  energies.clear();
  for (auto [l1, l2] : {std::pair{1.0, 1.0}, {0.1, 0.3}, {0.4, 0.02}, {5.0, 2.0}}) {
    Strand strand = toy_strand(random, 3);
    strand.bend_rigidity = EI;
    strand.rest_length << l1, l2;
    Posed posed{strand, VectorXd::Zero(9), "one joint"};
    posed.x.segment<3>(3) = l1 * along;
    posed.x.segment<3>(6) = l1 * along + l2 * bent;
    energies.push_back(ask_energy(trial, posed) * (l1 + l2));
  }
  expect_all_equal(trial, energies, 4096 * kUnit,
                   "how a joint's energy times its segments' lengths changes with them");

  // All lengths divided by r: E grows like r, f like r^2, products like r^3; down to hair of 1 mm a segment.
  const Posed large = random_pose(random, toy_strand(random, 6), {1, 1}, {0.2, 1}, "rest lengths of 1 m");
  const VectorXd dx = random_vector(random, large.x.size());
  const double E = ask_energy(trial, large);
  const VectorXd f = ask_force(trial, large), df = ask_product(trial, large, dx),
                 spd = ask_spd(trial, large, dx);
  expect_size(trial, f.norm(), reference_force(large).norm(), "the force");
  expect_size(trial, df.norm(), reference_product(large, dx, kProduct).norm(), "the product");
  expect_size(trial, spd.norm(), reference_product(large, dx, kSpdProduct).norm(), "the product");
  for (double r : {8.0, 1024.0}) {  // powers of two: nothing rounds differently
    Posed small = large;
    small.strand.rest_length /= r;
    small.x /= r;
    small.name = "scaled";
    auto expect = [&](const VectorXd& actual, const VectorXd& expected, const std::string& what) {
      expect_vector(trial, actual, expected, 1e-12 * largest(expected), what);
    };
    expect(VectorXd::Constant(1, ask_energy(trial, small)), VectorXd::Constant(1, E * r),
           "a short strand's energy");
    expect(ask_force(trial, small), f * r * r, "a short strand's force");
    expect(ask_product(trial, small, dx), df * r * r * r, "a short strand's product");
    expect(ask_spd(trial, small, dx), spd * r * r * r, "a short strand's product");
  }
}

void added(Trial& trial) {
  Random& random = trial.random;
  const Posed posed =
      random_pose(random, toy_strand(random, 9), kStretch, {0.2, 2}, "added to what is there");
  const VectorXd dx = random_vector(random, posed.x.size()), before = random_vector(random, posed.x.size());
  auto bound = [&](const VectorXd& of) { return 16 * kUnit * (largest(of) + largest(before)); };
  const VectorXd f = ask_force(trial, posed);
  expect_size(trial, f.norm(), reference_force(posed).norm(), "the force");
  expect_vector(trial, ask_force(trial, posed, before), f + before, bound(f) + force_rounding(posed),
                "the force that is added to what f held");
  for (int function : {kProduct, kSpdProduct}) {
    const VectorXd df = ask_product(trial, posed, dx, GeometricTerm::full, function);
    expect_size(trial, df.norm(), reference_product(posed, dx, function).norm(), "the product");
    expect_vector(trial, ask_product(trial, posed, dx, before, GeometricTerm::full, function), df + before,
                  bound(df) + product_rounding(posed, dx), "the product that is added to what df held");
  }
}

}  // namespace

std::vector<Category> categories() {
  return {{"Energy", "The energy", 2, energy},
          {"SingleJoint", "The force of a single joint", 3, single_joint},
          {"StrandForces", "The forces of a strand", 1, strand_forces},
          {"Balance", "Forces in balance", 2, balance},
          {"ClampedRoot", "The clamped root", 2, clamped_root},
          {"NearlyStraight", "Nearly straight", 2, nearly_straight},
          {"StraightProducts", "Products of a straight strand", 1, straight_products},
          {"LostDirections", "The fold, and particles in the same place", 2, lost_directions},
          {"ExactProduct", "The exact product", 3, exact_product},
          {"SpdProduct", "The semi-definite product", 3, spd_product},
          {"Sampling", "Lengths and sampling", 3, sampling},
          {"Added", "Added to what is there", 1, added}};
}

}  // namespace grader::h2
