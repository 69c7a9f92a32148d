#include "hair/simulation/methods.h"

#include <string>

#include "solver/course.h"

namespace hair {

namespace {

using particles::ToyMethod;

constexpr std::string_view kExplicit[] = {"P1"};
constexpr std::string_view kImplicit[] = {"S1", "H4"};
constexpr std::string_view kCorrected[] = {"S1", "H4", "H5", "H6"};

// Names what is linked only in a course that has it.
template <const auto& step, bool is_there>
constexpr auto step_of() -> decltype(&step) {
  if constexpr (is_there)
    return &step;
  else
    return nullptr;
}

constexpr bool kP1 = in_course("P1"), kH4 = in_course("H4"), kH6 = in_course("H6"), kH7 = in_course("H7");

constexpr MethodRow kMethods[] = {
    {Method::forward_euler, "forward_euler", "forward Euler", kExplicit, 1, 1, true, false, 1,
     "the least of 2 zeta/omega and 2/|lambda|", step_of<kForwardEuler, kP1>(), nullptr,
     ToyMethod::forward_euler},
    {Method::symplectic_euler, "symplectic_euler", "symplectic Euler", kExplicit, 1, 1, true, false, 0,
     "2 (sqrt(1 + zeta^2) - zeta)/omega", step_of<kSymplecticEuler, kP1>(),
     step_of<kLinkSymplecticEuler, kH7>(), ToyMethod::symplectic_euler},
    {Method::midpoint, "midpoint", "midpoint", kExplicit, 2, 2, true, false, 2, "|1 + z + z^2/2| = 1",
     step_of<kMidpoint, kP1>(), nullptr, ToyMethod::midpoint},
    {Method::runge_kutta_4, "runge_kutta_4", "Runge-Kutta 4", kExplicit, 4, 4, true, false, 4,
     "RK4's |R(h lambda)| = 1", step_of<kRungeKutta4, kP1>(), step_of<kLinkRungeKutta4, kH7>(),
     ToyMethod::runge_kutta_4},
    {Method::implicit_euler, "implicit_euler", "implicit Euler", kImplicit, 1, 1, false, false, 0,
     "what its matrix leaves out", step_of<kImplicitEuler, kH4>(), step_of<kLinkImplicitEuler, kH7>(),
     ToyMethod::implicit_euler},
    {Method::predictor_corrector, "predictor_corrector", "predictor and corrector", kCorrected, 1,
     2 /* for each of its two solves one */, false, true, 0, "across the hair",
     step_of<kPredictorCorrector, kH6>()},
    {Method::newton_euler, "newton_euler", "implicit Euler by Newton's method", kImplicit, 1, 1, false, false,
     0, "", step_of<kNewtonEuler, kH4>()},
};

}  // namespace

std::span<const MethodRow> methods() {
  return kMethods;
}

const MethodRow& row_of(Method method) {
  return kMethods[static_cast<std::size_t>(method)];
}

const StepMethod& mass_spring_step(Method method) {
  const MethodRow& row = row_of(method);
  if (!row.mass_spring) require_exercise(row.name, std::string(row.exercises.back()));
  return *row.mass_spring;
}

}  // namespace hair
