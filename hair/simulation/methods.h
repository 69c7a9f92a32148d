// The table of time methods: a row holds everything that the rest of the project needs about a method, and
// its step for masses and springs. Its step for another model is in the model's folder, with a place in the
// table of <model>_strand.cpp.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "hair/geometric_term.h"
#include "particles/toys/toy.h"

namespace hair {

// The rows that code names, in the table's order. Those that only scenes name come after them.
enum class Method {
  forward_euler,
  symplectic_euler,
  midpoint,
  runge_kutta_4,
  implicit_euler,
  predictor_corrector
};

struct StepMethod;

struct MethodRow {
  const char* id;                               // in scenes and records: "forward_euler"
  const char* name;                             // in sentences: "forward Euler"
  std::span<const std::string_view> exercises;  // the exercises that it calls; the last one is its own
  int order;                                    // order of its error in time
  int evaluations;                              // evaluations of the forces in a step, without iterations
  bool is_explicit = false;
  bool keeps_lengths = false;
  int polynomial = 0;  // the power up to which its amplification is the Taylor series of exp; 0: other
  const char* limit;   // the theoretical limit of its steps, in words
  const char* energy;  // "gains energy": the error of its energy, in words

  const StepMethod* springs;  // moves masses and springs: hair/mass_spring/step_methods.h

  std::optional<particles::ToyMethod> toy = {};  // the toys' method; none: toys don't have it

  Method method() const;  // its index in the table

  // The geometric term that a scene gets if it names none. Segments of exactly their rest length have no such
  // term. But 1 - l0/l has rounding errors, and the filter keeps only the positive ones: their mean acts like
  // a drag of about u k h^2 / m.
  GeometricTerm usual_term() const {
    return keeps_lengths ? GeometricTerm::dropped : GeometricTerm::filtered;
  }
};

std::span<const MethodRow> methods();
const MethodRow& row_of(Method method);

}  // namespace hair
