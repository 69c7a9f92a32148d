#include "hair/lab/study/study_methods.h"

#include <algorithm>

namespace hair {

namespace {

const std::vector<StudyMethod>& all_methods() {
  using enum GeometricTerm;
  using enum BendProduct;
  static const std::vector<StudyMethod> methods = {
      {"forward-euler", "forward Euler", Method::forward_euler, full, BendProduct::exact, 1, true},
      {"symplectic-euler", "symplectic Euler", Method::symplectic_euler, full, BendProduct::exact, 1, true},
      {"midpoint", "midpoint", Method::midpoint, full, BendProduct::exact, 2, true},
      {"runge-kutta-4", "RK4", Method::runge_kutta_4, full, BendProduct::exact, 4, true},
      {"h4-filtered", "H4, filtered", Method::implicit_euler, filtered, spd},
      {"h4-filtered-exact", "H4, filtered, exact bending", Method::implicit_euler, filtered,
       BendProduct::exact},
      {"h4-full", "H4, full", Method::implicit_euler, full, spd},
      {"h4-full-exact", "H4, full, exact bending", Method::implicit_euler, full, BendProduct::exact},
      {"h4-dropped", "H4, dropped", Method::implicit_euler, dropped, spd},
      {"h4-dropped-exact", "H4, dropped, exact bending", Method::implicit_euler, dropped, BendProduct::exact},
      {"newton-euler", "implicit Euler to convergence", Method::newton_euler, full, BendProduct::exact},
      {"h6", "H6", Method::predictor_corrector, filtered, spd},
  };
  return methods;
}

// HAIR_HAS_P1 and the like are defined for the course's exercises.
bool is_taught(const StudyMethod& method) {
  if (method.is_explicit) {
#ifdef HAIR_HAS_P1
    return true;
#else
    return false;
#endif
  }
#ifdef HAIR_HAS_H6
  if (method.method == Method::predictor_corrector) return true;
#endif
#ifdef HAIR_HAS_H4
  if (method.method != Method::predictor_corrector) return true;
#endif
  return false;
}

bool fits(const StudyMethod& method, const Problem& problem) {
  if (problem.is_toy()) {
    const Toy& toy = problem.scene.toys[0];
    if (method.is_explicit) return true;
    return method.id == "h4-filtered" && toy.constraints.rods.empty() && toy.constraints.wires.empty();
  }
  // Without bending there is no choice of its product.
  const bool bends = problem.scene.hair.strands[0].strand.bend_rigidity > 0;
  return bends || method.is_explicit || method.method == Method::newton_euler ||
         method.bend_product == BendProduct::spd;
}

ToyMethod toy_method(Method method) {
  switch (method) {
    case Method::forward_euler:
      return ToyMethod::forward_euler;
    case Method::symplectic_euler:
      return ToyMethod::symplectic_euler;
    case Method::midpoint:
      return ToyMethod::midpoint;
    case Method::runge_kutta_4:
      return ToyMethod::runge_kutta_4;
    default:
      return ToyMethod::implicit_euler;
  }
}

}  // namespace

std::vector<StudyMethod> methods_for(const Problem& problem) {
  std::vector<StudyMethod> methods;
  for (const StudyMethod& method : all_methods())
    if (is_taught(method) && fits(method, problem)) methods.push_back(method);
  return methods;
}

Scene with_method(const Problem& problem, const StudyMethod& method, int steps_per_frame) {
  Scene scene = problem.scene;
  scene.steps_per_frame = steps_per_frame;
  scene.hair.step = problem.duration / scene.frames / steps_per_frame;
  scene.hair.method = method.method;
  scene.hair.geometric_term = method.geometric_term;
  scene.hair.bend_product = method.bend_product;
  for (Toy& toy : scene.toys) toy.method = toy_method(method.method);
  return scene;
}

}  // namespace hair
