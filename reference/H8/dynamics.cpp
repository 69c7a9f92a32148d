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

}  // namespace grader::h8
