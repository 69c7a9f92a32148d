// STAFF ONLY. Hidden cases of H8's stiffness, forces, masses and steps.
//
// Bounds: a coordinate's stiffness is a product of two numbers, and its elastic force one more: 1e-13.
// Generalised forces and masses are sums over at most 400 points of products of at most 5 factors. These have
// the sizes of Sizes, for arms from any point of the world: 500 u, say 1e-12. A missing part is at least a
// hundredth of the size. Steps have the contract's bound.
#include <cmath>

#include "hair/super_helix.h"
#include "reference/H8/answers.h"

namespace grader::h8 {
namespace {

constexpr double kProducts = 1e-13, kSums = 1e-12, kBackward = 1e-10;

// The largest of |a - b| / size over all entries; NaN if one is NaN.
double worst(const VectorXd& a, const VectorXd& b, const VectorXd& size) {
  const VectorXd errors = (a - b).cwiseAbs().cwiseQuotient(size);
  return errors.hasNaN() ? std::nan("") : errors.maxCoeff();
}

// No such difference is larger than `bound`. One number is a coordinate's; `block` for a matrix.
void expect_near(Trial& trial, const VectorXd& actual, const VectorXd& expected, const VectorXd& size,
                 double bound, const std::string& what, int block = 1) {
  trial.expect_at_most(worst(actual, expected, size), bound, what,
                       {actual.cwiseQuotient(size), expected.cwiseQuotient(size), block});
}

VectorXd reference_step(const Hair& hair, double h) {
  VectorXd change(hair.q.size());
  MatrixXd scratch(hair.q.size(), hair.q.size() + 10);
  hair::helix_step(hair.strand, hair.elements, hair.points, hair.q, hair.rates, h, scratch, change);
  return change;
}

// The residual with the reference's parts, or, if that is too large, with the student's own, so that a bug in
// one of those costs only its own category.
double step_error(Trial& trial, const Hair& hair, double h, const VectorXd& change) {
  const Parts ours = reference_parts(hair, h);
  double error = system_of(ours, h).error(change);
  if (error <= kBackward) return error;
  trial.ask_aside([&] {
    const Parts own{ask_mass(trial, hair), ask_force(trial, hair), ask_stiffness(trial, hair.strand),
                    ask_elastic(trial, hair.strand, hair.q + h * hair.rates)};
    if (comparable(own.M.norm(), ours.M.norm()) && comparable(own.K.norm(), ours.K.norm()) &&
        comparable(own.Q.norm(), ours.Q.norm()) && system_of(own, h).error(change) <= kBackward)
      error = 0;
  });
  return error;
}

void expect_step(Trial& trial, const Hair& hair, double h) {
  const VectorXd change = ask_step(trial, hair, h);
  trial.expect_at_most(step_error(trial, hair, h, change), kBackward,
                       "what (M + h^2 K) change = h (Q - K (q + h q' - q^n)) leaves",
                       {change, reference_step(hair, h), 1});
}

// Checks the step of a special strand. If ordinary steps are wrong, too, it only must not be 0 or much too
// large, so that this mistake costs one category.
void expect_special_step(Trial& trial, const Hair& hair, double h) {
  const VectorXd change = ask_step(trial, hair, h);
  double error = step_error(trial, hair, h, change);
  if (!(error <= kBackward)) {
    const VectorXd ours = reference_step(hair, h);
    trial.ask_aside([&] {
      const Hair ordinary = random_hair(trial.random, {.elements = 5});
      const bool wrong = !(step_error(trial, ordinary, 1e-3, ask_step(trial, ordinary, 1e-3)) <= kBackward);
      if (wrong && comparable(change.norm(), ours.norm())) error = 0;
    });
  }
  trial.expect_at_most(error, kBackward, "what (M + h^2 K) change = h (Q - K (q + h q' - q^n)) leaves");
}

}  // namespace

void stiffness(Trial& trial) {
  for (const int elements : {1, 2, 7, 40}) {
    const HelixStrand strand = random_hair(trial.random, {.elements = elements}).strand;
    VectorXd expected(3 * elements);
    hair::helix_stiffness(strand, expected);
    const VectorXd K = ask_stiffness(trial, strand);
    expect_near(trial, K, expected, expected, kProducts, "K");
  }
}

// A force that agrees with the student's own K is right, too, so that EI in place of GJ costs one category.
void elasticity(Trial& trial) {
  for (const int elements : {1, 2, 7, 40}) {
    const Hair hair = random_hair(trial.random, {.elements = elements});
    const HelixStrand& strand = hair.strand;
    const VectorXd bent = hair.q - strand.natural, size = hair.q.cwiseAbs() + strand.natural.cwiseAbs();
    VectorXd K(3 * elements);
    hair::helix_stiffness(strand, K);
    const VectorXd force = ask_elastic(trial, strand, hair.q);
    if (!(worst(force, -K.cwiseProduct(bent), K.cwiseProduct(size)) <= kProducts)) {
      trial.ask_aside([&] {
        const VectorXd own = ask_stiffness(trial, strand);
        if (own.minCoeff() > 0 && comparable(own.norm(), K.norm())) K = own;
      });
    }
    expect_near(trial, force, -K.cwiseProduct(bent), K.cwiseProduct(size), kProducts, "an elastic force");
  }
}

void forces(Trial& trial) {
  for (const int elements : {1, 2, 5, 20}) {
    const Hair hair = random_hair(trial.random, {.elements = elements});
    VectorXd expected(hair.q.size());
    hair::generalised_force(hair.elements, hair.points, expected);
    expect_near(trial, ask_force(trial, hair), expected, sizes_of(hair).force, kSums, "a generalised force");
  }
}

void masses(Trial& trial) {
  for (const int elements : {1, 2, 5, 20}) {
    const Hair hair = random_hair(trial.random, {.elements = elements});
    MatrixXd expected(3 * elements, 3 * elements);
    hair::mass_matrix(hair.elements, hair.points, expected);
    const MatrixXd M = ask_mass(trial, hair);
    const VectorXd root = sizes_of(hair).mass;
    const MatrixXd size = root * root.transpose();
    expect_near(trial, M.reshaped(), expected.reshaped(), size.reshaped(), kSums, "an entry of M",
                static_cast<int>(M.size()));
  }
}

void steps(Trial& trial) {
  for (const int elements : {1, 2, 5, 12})
    for (const double h : {1e-3, 1.0 / 60})
      expect_step(trial, random_hair(trial.random, {.elements = elements}), h);
}

void stiff_steps(Trial& trial) {
  for (const int elements : {1, 10, 40})
    expect_special_step(trial, straight_hair(trial.random, elements), 1.0 / 30);
  for (const int elements : {2, 40})
    expect_special_step(trial, random_hair(trial.random, {.elements = elements}), 1.0 / 30);
  expect_special_step(trial, random_hair(trial.random, {.elements = 3, .least = 100, .most = 126}), 1e-3);
}

// The cases below compare a student's answer with the student's own answer to another question, so that each
// shows only one kind of mistake.
//
// Bounds: those of each function's own cases. Changes of a step solve a system whose condition number is
// below 1e4 at h = 1/60 s, as the stiffness outweighs the masses. Each of two changes has a residual of 1e-10
// its two parts: 4e-6, say 1e-5. The answers must not be 0 where the reference's are not; other cases check
// their exact size.

namespace {

// Compares two answers: vectors, frames or matrices as rows of numbers. Braces ask in their order,
// whichever compiler made the suite.
struct Both {
  MatrixXd one, other;
};

void expect_same(Trial& trial, const Both& both, double part, const std::string& what) {
  const auto& [one, other] = both;
  const double size = one.norm();
  trial.expect(size > 0, what + " is 0");
  trial.expect_at_most((one - other).norm(), part * size, what, {one.reshaped(), other.reshaped()});
}

}  // namespace

// Elements without points pass on the pull from further out, as they do with points that have no force and no
// mass.
void bare_elements(Trial& trial) {
  for (const int elements : {2, 5, 20}) {
    const Hair hair = random_hair(trial.random, {.elements = elements});
    const int last = trial.random.integer(0, elements - 2);
    for (const int first : {last, 0}) {
      Hair light = hair, bare = hair;
      const auto is_bare = [&](const hair::HelixPoint& point) {
        return point.element >= first && point.element <= last;
      };
      for (hair::HelixPoint& point : light.points)
        if (is_bare(point)) point.force.setZero(), point.inertia.setZero();
      std::erase_if(bare.points, is_bare);
      expect_same(trial, {ask_force(trial, bare), ask_force(trial, light)}, 1e-9,
                  "a generalised force where elements have no points");
      expect_same(trial, {ask_mass(trial, bare), ask_mass(trial, light)}, 1e-9,
                  "M where elements have no points");
    }
  }
}

// Hair may have any thickness and weight, so no threshold in kg, m or N may show.
void other_units(Trial& trial) {
  const double h = 1.0 / 60;
  for (const Units& units : {Units{.mass = 0x1p-60}, Units{.length = 0x1p-40}, Units{0x1p60, 0x1p40}}) {
    const auto [mass, length] = units;
    const Hair hair = random_hair(trial.random, {.elements = 3}), other = in_units(hair, units);
    const VectorXd ahead = hair.q + h * hair.rates, other_ahead = other.q + h * other.rates;
    const double rigid = mass * length * length;
    const hair::HelixElement &element = hair.elements[1], &small = other.elements[1];

    const MaterialFrame end = ask_frame(trial, element.start, element.curvature, element.length),
                        small_end = ask_frame(trial, small.start, small.curvature, small.length);
    expect_same(trial,
                {Vector3d(end.position - element.start.position),
                 Vector3d((small_end.position - small.start.position) / length)},
                1e-9, "the centre line in other units");
    expect_same(trial, {end.axes, small_end.axes}, 1e-9, "a frame in other units");
    const hair::HelixJacobian J = ask_jacobian(trial, element.start, element.curvature, element.length),
                              small_J = ask_jacobian(trial, small.start, small.curvature, small.length);
    expect_same(trial, {J.moves, Matrix3d(small_J.moves / (length * length))}, 1e-9,
                "how a point moves in other units");
    expect_same(trial, {J.turns, Matrix3d(small_J.turns / length)}, 1e-9, "how a frame turns in other units");
    expect_same(trial,
                {ask_stiffness(trial, hair.strand),
                 VectorXd(ask_stiffness(trial, other.strand) / (rigid * length * length))},
                1e-12, "K in other units");
    expect_same(trial,
                {ask_elastic(trial, hair.strand, ahead),
                 VectorXd(ask_elastic(trial, other.strand, other_ahead) / (rigid * length))},
                1e-11, "an elastic force in other units");
    expect_same(trial, {ask_force(trial, hair), VectorXd(ask_force(trial, other) / (rigid * length))}, 1e-11,
                "a generalised force in other units");
    expect_same(trial, {ask_mass(trial, hair), MatrixXd(ask_mass(trial, other) / (rigid * length * length))},
                1e-11, "M in other units");
    expect_same(trial, {ask_step(trial, hair, h), VectorXd(ask_step(trial, other, h) * length)}, 1e-5,
                "a step in other units");
  }
}

}  // namespace grader::h8
