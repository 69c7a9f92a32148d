// STAFF ONLY. The calls of H6; see grader/calls/call.h.
#pragma once

#include "grader/calls/call.h"
#include "hair/predictor_corrector.h"

namespace grader {

template <>
struct Form<hair::StepReport> {
  using T = hair::StepReport;
  static constexpr auto fields = std::tuple(&T::filter, &T::correction, &T::second_filter);
};

}  // namespace grader

namespace grader::h6 {

struct Calls
    : CallList<
          Call<hair::predictor_corrector, Contract{.scratch_columns = hair::kPredictorCorrectorScratch}>> {
  static constexpr const char* id = "H6";
};

}  // namespace grader::h6
