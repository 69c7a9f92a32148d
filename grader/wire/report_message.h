// STAFF ONLY. The reports of H4 and H5 in a message.
#pragma once

#include "grader/wire/message.h"
#include "hair/length_correction.h"
#include "particles/implicit_euler.h"

namespace grader {

// Steps as an untrusted sender counts them: bounded, so that sums of a few such numbers are still ints.
inline int get_steps(MessageReader& message, int most = 1 << 28) {
  const int steps = message.get<int>();
  return steps < 0 ? 0 : steps < most ? steps : most;
}

inline void put(MessageWriter& message, const particles::SolveReport& report) {
  message.put(report.steps)
      .put(report.residual)
      .put(report.rhs)
      .put(report.converged)
      .put(report.preconditioned);
}

inline void put(MessageWriter& message, const hair::CorrectionReport& report) {
  message.put(report.iterations).put(report.error).put(report.converged);
}

inline particles::SolveReport get_solve_report(MessageReader& message) {
  particles::SolveReport report;
  report.steps = get_steps(message);
  report.residual = message.get<double>();
  report.rhs = message.get<double>();
  report.converged = message.get<std::uint8_t>() != 0;
  report.preconditioned = message.get<std::uint8_t>() != 0;
  return report;
}

inline hair::CorrectionReport get_correction_report(MessageReader& message) {
  hair::CorrectionReport report;
  report.iterations = get_steps(message);
  report.error = message.get<double>();
  report.converged = message.get<std::uint8_t>() != 0;
  return report;
}

}  // namespace grader
