// The table of time methods: a row holds everything that the rest of the project knows about a method. No
// other code distinguishes methods, so a new method is one row here, and for each model that it moves a step in the model's room and
// its place in the model's table of steps, in <model>_strand.cpp.
#pragma once

#include <iterator>
#include <optional>
#include <span>
#include <string_view>

#include "hair/geometric_term.h"
#include "particles/toys/toy.h"

namespace hair {

enum class Method {
  forward_euler,
  symplectic_euler,
  midpoint,
  runge_kutta_4,
  implicit_euler,
  predictor_corrector
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

  std::optional<particles::ToyMethod> toy = {};  // the toys' method; none: toys don't have it

  // The geometric term that a scene gets if it asks for none. Segments of exactly their rest length have no such term.
  // But 1 - l0/l rounds, to a positive mean once the filter takes its negative values away: a drag of about u k h^2 / m.
  GeometricTerm usual_term() const {
    return keeps_lengths ? GeometricTerm::dropped : GeometricTerm::filtered;
  }
};

std::span<const MethodRow> methods();  // in the order of the enumeration
const MethodRow& row_of(Method method);

// In a model's table of {method, step}: the step. Null: such strands don't move by this method.
template <class Steps>
auto step_of(const Steps& steps, Method method) -> decltype(&std::begin(steps)->step) {
  for (const auto& row : steps)
    if (row.method == method) return &row.step;
  return nullptr;
}

}  // namespace hair
