// The table of time methods: a row holds everything that the rest of the project knows about a method. No
// other code distinguishes methods, so a new method is one row here, and a step function in the folder of
// each model that it moves.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "hair/geometric_term.h"
#include "hair/mass_spring/step_methods.h"
#include "hair/simulation/rigid_links_strand.h"
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
  std::span<const std::string_view> exercises;  // the exercises that it calls; the last one is its own
  int order;                                    // of its error in time
  int evaluations;                              // of the forces in a step, without iterations
  bool is_explicit = false;
  bool keeps_lengths = false;
  int polynomial = 0;  // the power up to which its amplification is the Taylor series of exp; 0: other
  const char* limit;   // the theoretical limit of its steps, in words

  const StepMethod& mass_spring;  // the step of such a strand
  const LinkMethod* rigid_links =
      nullptr;  // the step of a strand of rigid links; null: it has none, or the same
  std::optional<particles::ToyMethod> toy = {};  // the toys' method; none: toys don't have it

  // The geometric term that a scene gets if it asks for none. Segments of exactly their rest length have no such term.
  // But 1 - l0/l rounds, to a positive mean once the filter takes its negative values away: a drag of about u k h^2 / m.
  GeometricTerm usual_term() const {
    return keeps_lengths ? GeometricTerm::dropped : GeometricTerm::filtered;
  }
};

std::span<const MethodRow> methods();  // in the order of the enumeration
const MethodRow& row_of(Method method);

}  // namespace hair
