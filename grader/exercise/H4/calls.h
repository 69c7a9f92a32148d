// STAFF ONLY. The calls of H4; see grader/exercise/call.h.
#pragma once

#include "grader/exercise/call.h"
#include "particles/implicit_euler.h"

namespace grader::h4 {

inline constexpr Contract kSolves = {.scratch_columns = particles::kImplicitScratch,
                                     .allocates_nothing = true};

struct Calls : CallList<Call<particles::implicit_matrix, Contract{.allocates_nothing = true}>,
                        Call<particles::solve_implicit, kSolves>, Call<particles::implicit_euler, kSolves>> {
  static constexpr const char* id = "H4";
};

}  // namespace grader::h4
