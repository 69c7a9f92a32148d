// STAFF ONLY. The calls of H1; see grader/calls/call.h.
#pragma once

#include "grader/calls/call.h"
#include "hair/stretch_springs.h"

namespace grader::h1 {

struct Calls
    : CallList<Call<hair::stretch_energy>, Call<hair::add_stretch_force>, Call<hair::add_stretch_product>> {
  static constexpr const char* id = "H1";
};

}  // namespace grader::h1
