// STAFF ONLY. The calls of H5; see grader/calls/call.h.
#pragma once

#include "grader/calls/call.h"
#include "hair/length_correction.h"

namespace grader::h5 {

struct Calls
    : CallList<
          Call<hair::relax_lengths, Contract{.sweeps = 2}>,
          Call<hair::correct_lengths, Contract{.scratch_columns = hair::kCorrectionScratch, .sweeps = 2}>,
          Call<hair::correct_velocities,
               Contract{.scratch_columns = hair::kCorrectionScratch, .sweeps = 3}>> {
  static constexpr const char* id = "H5";
};

}  // namespace grader::h5
