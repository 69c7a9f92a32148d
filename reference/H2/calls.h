// STAFF ONLY. The calls of H2; see grader/calls/call.h.
#pragma once

#include "grader/calls/call.h"
#include "hair/angular_springs.h"

namespace grader::h2 {

struct Calls : CallList<Call<hair::bend_energy>, Call<hair::add_bend_force>, Call<hair::add_bend_product>,
                        Call<hair::add_bend_product_spd>> {
  static constexpr const char* id = "H2";
};

}  // namespace grader::h2
