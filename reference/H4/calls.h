// STAFF ONLY. The calls of H4; see grader/calls/call.h.
#pragma once

#include "grader/calls/call.h"
#include "particles/implicit_euler.h"

namespace grader::h4 {

struct Calls
    : CallList<Call<particles::implicit_matrix, Contract{}>, Call<particles::implicit_rhs>,
               Call<particles::solve_plain>,
               Call<particles::implicit_euler, Contract{.scratch_columns = particles::kImplicitScratch}>> {
  static constexpr const char* id = "H4";
};

}  // namespace grader::h4
