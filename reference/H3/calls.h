// STAFF ONLY. The calls of H3; see grader/calls/call.h.
#pragma once

#include "grader/calls/call.h"
#include "hair/bend_springs.h"

namespace grader::h3 {

struct Calls : CallList<Call<hair::bend_spring_energy>, Call<hair::add_bend_spring_force>,
                        Call<hair::add_bend_spring_product>> {
  static constexpr const char* id = "H3";
};

}  // namespace grader::h3
