#include "hair/lab/study/study_methods.h"

#include "hair/course/course.h"

namespace hair {

namespace {

const std::vector<StudyMethod>& methods_of_springs() {
  using enum GeometricTerm;
  using enum Products;
  static const std::vector<StudyMethod> methods = {
      {"forward-euler", "forward Euler", Method::forward_euler, full, Products::exact},
      {"symplectic-euler", "symplectic Euler", Method::symplectic_euler, full, Products::exact},
      {"midpoint", "midpoint", Method::midpoint, full, Products::exact},
      {"runge-kutta-4", "RK4", Method::runge_kutta_4, full, Products::exact},
      {"h4-filtered", "H4, filtered", Method::implicit_euler, filtered, definite},
      {"h4-filtered-exact", "H4, filtered, exact bending", Method::implicit_euler, filtered, Products::exact},
      {"h4-filtered-plain", "H4, filtered, plain", Method::implicit_euler, filtered, definite, false},
      {"h4-full", "H4, full", Method::implicit_euler, full, definite},
      {"h4-full-plain", "H4, full, plain", Method::implicit_euler, full, definite, false},
      {"h4-full-exact", "H4, full, exact bending", Method::implicit_euler, full, Products::exact},
      {"h4-dropped", "H4, dropped", Method::implicit_euler, dropped, definite},
      {"h4-dropped-plain", "H4, dropped, plain", Method::implicit_euler, dropped, definite, false},
      {"h4-dropped-exact", "H4, dropped, exact bending", Method::implicit_euler, dropped, Products::exact},
      {"h6", "H6", Method::predictor_corrector, dropped, definite},
      {"h6-plain", "H6, plain", Method::predictor_corrector, dropped, definite, false},
  };
  return methods;
}

bool fits(const StudyMethod& method, const Problem& problem) {
  if (problem.is_toy()) {
    const Toy& toy = problem.scene.toys[0];
    if (method.is_explicit()) return true;
    return method.id == "h4-filtered" && toy.constraints.rods.empty() && toy.constraints.wires.empty();
  }
  // Without bending there is no choice of its product.
  const bool bends = problem.scene.hair.strands[0].strand.bend_rigidity > 0;
  return bends || method.is_explicit() || method.bend_product == Products::definite;
}

}  // namespace

std::vector<StudyMethod> methods_for(const Problem& problem, const std::vector<std::string>& absent) {
  std::vector<StudyMethod> methods;
  for (const StudyMethod& method : methods_of_springs())
    if (!calls_absent(row_of(method.method).exercises, absent) && fits(method, problem))
      methods.push_back(method);
  return methods;
}

Description with_options(Description hair, const StudyMethod& method) {
  hair.method = method.method;
  hair.geometric_term = method.geometric_term;
  hair.bend_product = method.bend_product;
  return hair;
}

Scene with_method(const Problem& problem, const StudyMethod& method, int steps_per_frame) {
  Scene scene = problem.scene;
  scene.steps_per_frame = steps_per_frame;
  scene.hair = with_options(std::move(scene.hair), method);
  scene.hair.step = problem.duration / scene.frames / steps_per_frame;
  scene.hair.preconditioner = method.preconditioner;
  scene.hair.watched = false;  // times are the methods' own
  for (Toy& toy : scene.toys) toy.method = row_of(method.method).toy.value_or(ToyMethod::implicit_euler);
  return scene;
}

}  // namespace hair
