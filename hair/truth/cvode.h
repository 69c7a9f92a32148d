// SUNDIALS' CVODE on a system of ordinary differential equations. A. C. Hindmarsh et al., "SUNDIALS: Suite of Nonlinear
// and Differential/Algebraic Equation Solvers", ACM Transactions on Mathematical Software 31 (2005).
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "hair/truth/ode.h"
#include "hair/truth/trajectory.h"

namespace hair {

// Backward differentiation, orders 1 to 5, its equations solved by Newton's method with a banded matrix; or Adams and
// Moulton, orders 1 to 12, by fixed-point iteration, which needs no matrix. BDF is for what is stiff and damped; what
// rings is followed by either, and with Adams' many orders cheaper.
enum class CvodeMethod { bdf, adams };

struct CvodeWay {
  CvodeMethod method = CvodeMethod::bdf;
  double tolerance = 1e-12;  // times an entry's scale: what a step may be wrong by, in the mean of squares
};

struct CvodeRun {
  Trajectory states;
  long evaluations = 0;  // of f
  long matrices = 0;     // of df/dy
  long steps = 0;
};

// The states at the start and at `moments` times at equal distances, of which the last is `duration` seconds. Empty if
// `interrupted`. Throws std::runtime_error with one line where CVODE gives up (f is not finite, steps vanish), and
// what f throws.
std::optional<CvodeRun> run_cvode(Ode& ode, double duration, int moments, const CvodeWay& way,
                                  const std::atomic<bool>& interrupted);

bool have_cvode();
std::string cvode_version();  // "6.4.1"; "" without

}  // namespace hair
