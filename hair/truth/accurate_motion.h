// The accurate motion of a problem: the solution of its ordinary differential equations by SUNDIALS' CVODE,
// with the strand's sparsity, as accurate as is practical. The time errors of methods are measured against
// it.
//
//   M x'' = f(x, x') for the free particles; the scene moves the held ones.
//
// CVODE solves each problem twice, in two ways. The result includes their agreement; smaller errors are
// meaningless. If a strand is so hard to stretch that CVODE would take minutes (kHardToStretch times hair's
// EA), it is replaced by its inextensible limit: the equations with rigid segments (rigid_strand_ode.h). The
// difference of the two motions falls like 1/EA, is known from the tensions, and is included in the
// agreement. A strand that does not start with its rest lengths has no such limit, because it oscillates
// along its length for ever; CVODE takes minutes for it.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>

#include "hair/truth/ode.h"
#include "hair/truth/problem.h"

namespace hair {

inline constexpr double kTightest = 1e-12;     // a relative tolerance: below it only rounding is left
inline constexpr double kLeastError = 1e-10;   // m: smaller errors are not reported
inline constexpr double kHardToStretch = 100;  // times the EA of hair of the same thickness

struct AccurateMotion {
  Trajectory states;
  // m, the largest distance of a particle at any moment between the two solutions; or,
  // if larger, between the inextensible limit and the strand that stretches (four times the stretch by the
  // tensions).
  double agreement = 0;
  std::string method;  // "CVODE 6.4.1: Adams at 1e-12, beside BDF at 1e-12"
  bool inextensible = false;
  bool from_cache = false;
  double cpu_seconds = 0;  // when it was computed
  long evaluations = 0;    // evaluations of the forces

  double least_error() const;  // max(agreement, kLeastError): smaller errors are not reported
};

struct AccurateSettings {
  double tolerance = kTightest;  // > 0, relative to the strand's length, for each step; at least kTightest

  // A folder for computed motions (find_motion), or none. A folder that can't be written is ignored.
  std::optional<std::filesystem::path> cache = {};
};

// Throws std::runtime_error if CVODE fails, as it does for forces that are not finite or jump;
// std::invalid_argument without SUNDIALS (check have_accurate_motion() before); and the forces' own
// exceptions. Empty if `interrupted` before the end.
std::optional<AccurateMotion> accurate_motion(const Problem& problem, const AccurateSettings& settings,
                                              const std::atomic<bool>& interrupted);
bool have_accurate_motion();

// The largest distance of a particle between two states, m; for trajectories, over all moments that both
// have.
double largest_distance(const Eigen::VectorXd& x, const Eigen::VectorXd& y);
double largest_distance(const Trajectory& a, const Trajectory& b);

// ---- A cache of accurate motions: files that are kept (hair/io/files/kept_file.h) ----

// Everything that a motion depends on, in one line: the problem, the solution method, the versions, and the
// forces, as digests of f at the start and near it, because the code of an exercise may have changed.
std::string motion_key(const Problem& problem, Ode& ode, const std::string& method);

// The stored motion, bit by bit, with from_cache set; nothing if there is none, or if the file is not valid.
std::optional<AccurateMotion> find_motion(const std::filesystem::path& folder, const std::string& key);

// Throws BadInput if the folder can't be written.
void keep_motion(const std::filesystem::path& folder, const std::string& key, const AccurateMotion& motion);

}  // namespace hair
