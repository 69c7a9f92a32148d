// STAFF ONLY. The calls of P1; see grader/calls/call.h.
#pragma once

#include "grader/calls/call.h"
#include "particles/explicit_integrators.h"

namespace grader::p1 {

inline constexpr Contract kStep = {.scratch_columns = particles::kIntegratorScratch};

struct Calls : CallList<Call<particles::forward_euler, kStep>, Call<particles::symplectic_euler, kStep>,
                        Call<particles::midpoint, kStep>, Call<particles::runge_kutta_4, kStep>> {
  static constexpr const char* id = "P1";
};

}  // namespace grader::p1
