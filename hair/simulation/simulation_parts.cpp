#include "hair/simulation/simulation_parts.h"

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "hair/mass_spring/rest_curvature.h"
#include "particles/drag.h"
#include "particles/gravity.h"

namespace hair {

namespace {

// HAIR_HAS_H1 and the like are defined for the course's exercises.
[[maybe_unused, noreturn]] void leave_out(const std::string& what, const std::string& exercise) {
  throw std::invalid_argument(what + " needs exercise " + exercise + ", which this course leaves out");
}

}  // namespace

StepMethod method_of(Method method) {
  switch (method) {
#ifdef HAIR_HAS_P1
    case Method::forward_euler:
      return kForwardEuler;
    case Method::symplectic_euler:
      return kSymplecticEuler;
    case Method::midpoint:
      return kMidpoint;
    case Method::runge_kutta_4:
      return kRungeKutta4;
#endif
#ifdef HAIR_HAS_H4
    case Method::implicit_euler:
      return kImplicitEuler;
    case Method::newton_euler:
      return kNewtonEuler;
#endif
#ifdef HAIR_HAS_H6
    case Method::predictor_corrector:
      return kPredictorCorrector;
#endif
    default:
      break;
  }
  if (method == Method::predictor_corrector) leave_out("the predictor-corrector", "H6");
  if (method == Method::implicit_euler || method == Method::newton_euler) leave_out("implicit Euler", "H4");
  leave_out("an explicit method", "P1");
}

namespace {

// To `sum`, with products as said.
void add_parts(const Description& description, const StrandStart& start, GeometricTerm geometric_term,
               BendProduct bend_product, MovingStrand& moving, particles::ForceSum& sum) {
  const Strand& strand = moving.strand;
  if (strand.stretch_rigidity > 0) {
#ifdef HAIR_HAS_H1
    sum.emplace<StretchForce>(strand, geometric_term);
#else
    leave_out("stretching", "H1");
#endif
  }
  if (strand.bend_rigidity > 0 && start.rest_curvature.size() > 0) {
    auto rest =
        std::make_unique<RestCurvature>(strand, start.rest_curvature, start.root_normal, bend_product);
    moving.rest_curvatures.push_back(rest.get());
    sum.add(std::move(rest));
  } else if (strand.bend_rigidity > 0) {
#ifdef HAIR_HAS_H2
    sum.emplace<BendForce>(strand, bend_product);
#else
    leave_out("bending", "H2");
#endif
  }
  if (strand.skip_rigidity > 0) {
#ifdef HAIR_HAS_H3
    sum.emplace<BendSpringForce>(strand, geometric_term);
#else
    leave_out("springs that skip a particle", "H3");
#endif
  }
  if (description.gravity != Vector3d::Zero())
    sum.emplace<particles::Gravity>(strand.mass, description.gravity);
  if (description.drag > 0) {
    // Half of the segments on either side, as for masses.
    Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(strand.count());
    coefficients.head(strand.segments()) += description.drag / 2 * strand.rest_length;
    coefficients.tail(strand.segments()) += description.drag / 2 * strand.rest_length;
    sum.emplace<particles::Drag>(std::move(coefficients), description.wind);
  }
}

}  // namespace

void add_forces(const Description& description, const StrandStart& start, MovingStrand& moving) {
  using enum GeometricTerm;
  using enum BendProduct;
  if (description.method == Method::newton_euler) {
    add_parts(description, start, full, exact, moving, moving.force);
    add_parts(description, start, filtered, spd, moving, moving.definite_force);
  } else {
    add_parts(description, start, description.geometric_term, description.bend_product, moving, moving.force);
  }
}

}  // namespace hair
