// STAFF ONLY. The calls of X1; see grader/exercise/call.h.
#pragma once

#include "grader/exercise/call.h"
#include "particles/air_drag.h"

namespace grader::x1 {

struct Calls : CallList<Call<particles::add_air_drag>> {
  static constexpr const char* id = "X1";
};

}  // namespace grader::x1
