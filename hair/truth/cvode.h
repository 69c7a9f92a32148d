// SUNDIALS' CVODE on a system of ordinary differential equations. A. C. Hindmarsh et al., "SUNDIALS: Suite of
// Nonlinear and Differential/Algebraic Equation Solvers", ACM Transactions on Mathematical Software 31
// (2005).
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "hair/truth/ode.h"

namespace hair {

// BDF: backward differentiation, orders 1 to 5, with Newton's method and a banded matrix. Adams:
// Adams-Moulton, orders 1 to 12, with fixed-point iteration, which needs no matrix. BDF suits stiff, damped
// systems. Both follow undamped oscillations; Adams is cheaper there because of its high orders.
enum class CvodeMethod { bdf, adams };

struct CvodeWay {
  CvodeMethod method = CvodeMethod::bdf;
  double tolerance = 1e-12;  // times an entry's scale: the allowed error of a step, root mean square
};

struct CvodeRun {
  Trajectory states;
  long evaluations = 0;  // evaluations of f
};

// Returns the states at the start and at `moments` equally spaced times, the last one at `duration` seconds.
// Empty if `interrupted`. Throws std::runtime_error with one line if CVODE fails (f is not finite, steps
// vanish), and passes on exceptions of f.
std::optional<CvodeRun> run_cvode(Ode& ode, double duration, int moments, const CvodeWay& way,
                                  const std::atomic<bool>& interrupted);

bool have_cvode();
std::string cvode_version();  // "6.4.1"; "" if there is none

}  // namespace hair
