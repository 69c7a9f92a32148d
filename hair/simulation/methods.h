// The table of time methods: a row has all that the rest of the project knows of a method. Nothing else asks which method
// it is, so that a new one is a row here, and a step in the room of each model that it moves.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "hair/mass_spring/step_methods.h"
#include "particles/toys/toy.h"

namespace hair {

enum class Method {
  forward_euler,
  symplectic_euler,
  midpoint,
  runge_kutta_4,
  implicit_euler,
  predictor_corrector,
  newton_euler  // implicit Euler by Newton's method to convergence: for studies, not for hair
};

struct MethodRow {
  Method method;
  const char* id;                               // in scenes and records: "forward_euler"
  const char* name;                             // in sentences: "forward Euler"
  std::span<const std::string_view> exercises;  // that it calls; the last one is its own
  int order;                                    // of its error in time
  int evaluations;                              // of the forces in a step, to begin with
  bool is_explicit;
  bool keeps_lengths;
  int polynomial;     // its amplification is the series of exp up to this power; 0: it is none of these
  const char* limit;  // what bounds its steps in theory, in words

  const StepMethod* mass_spring;                 // a step of such a strand; null: the course leaves it out
  std::optional<particles::ToyMethod> toy = {};  // the toys' method; none: toys have no such one
};

std::span<const MethodRow> methods();  // in the order of the enumeration
const MethodRow& row_of(Method method);

// The step of a strand of masses and springs. Throws std::invalid_argument for one that the course leaves out.
const StepMethod& mass_spring_step(Method method);

}  // namespace hair
