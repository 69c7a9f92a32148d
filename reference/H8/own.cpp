// STAFF ONLY. Hidden cases of H8 that compare a student's answer with the student's own answer to another
// question, so that each shows only one kind of mistake.
//
// Bounds: those of each function's own cases. Changes of a step solve a system whose condition number is
// below 1e4 at h = 1/60 s, as the stiffness outweighs the masses. Each of two changes has a residual of 1e-10
// its two parts: 4e-6, say 1e-5. The answers must not be 0 where the reference's are not; other cases check
// their exact size.
#include "hair/super_helix.h"
#include "reference/H8/answers.h"

namespace grader::h8 {
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
