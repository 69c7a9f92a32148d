// How a problem really moves: the solution of its ordinary differential equations, by SUNDIALS' CVODE, with the
// strand's sparsity, as accurate as pays. It is what a method's time error is measured against.
//
//   M x'' = f(x, x') for the particles that are free; those that are held move as the scene says.
//
// CVODE is asked twice, in two ways; how far the two agree is said, and no error below that means anything. A strand
// so hard to stretch that CVODE would take minutes (kHardToStretch times hair's EA) moves as one that does not stretch
// at all: the equations are those with rigid segments (rigid_strand_ode.h). How far the two are apart falls like 1/EA,
// is known from the tensions, and part of the agreement. One that starts with other lengths than it rests with has no
// such limit, for it never ends ringing: it takes its minutes.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>

#include "hair/truth/problem.h"
#include "hair/truth/trajectory.h"

namespace hair {

inline constexpr double kTightest = 1e-12;  // a relative tolerance: below it rounding is all there is to see
inline constexpr double kLeastError = 1e-10;   // m: nothing below is quoted
inline constexpr double kHardToStretch = 100;  // times the EA of hair as thick

struct AccurateMotion {
  Trajectory states;
  // m, the largest distance of a particle at any moment between the two solutions; or between the limit of rigid
  // segments and the strand that stretches (four times what tensions stretch it by), if that is more.
  double agreement = 0;
  std::string method;  // "CVODE 6.4.1: Adams at 1e-12, beside BDF at 1e-12"
  bool inextensible = false;
  bool from_cache = false;
  double cpu_seconds = 0;  // when it was computed
  long evaluations = 0;    // of the forces

  double least_error() const;  // max(agreement, kLeastError): below it no error is quoted
};

struct AccurateSettings {
  double tolerance = kTightest;  // > 0, of the strand's length, for each step; below kTightest it is that

  // A folder that motions are kept in (motion_cache.h), or none. One that can't be written is none.
  std::optional<std::filesystem::path> cache = {};
};

// Throws std::runtime_error where CVODE gives up, which it does of forces that are not finite or jump, and
// std::invalid_argument without SUNDIALS: have_accurate_motion() tells before; and what forces throw. Empty if
// `interrupted` before it was done.
std::optional<AccurateMotion> accurate_motion(const Problem& problem, const AccurateSettings& settings,
                                              const std::atomic<bool>& interrupted);
bool have_accurate_motion();

}  // namespace hair
