#include "hair/truth/space_error.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "hair/io/files/printable.h"
#include "hair/strand/measures.h"
#include "hair/truth/accurate_motion.h"
#include "hair/truth/cvode.h"
#include "hair/truth/rigid_strand_ode.h"
#include "solver/timing.h"

namespace hair {

namespace {

constexpr int kLevels = 4;
constexpr double kTolerance = 1e-9;       // for the accurate motions
constexpr double kOtherTolerance = 1e-8;  // for a second solution that shows their accuracy
constexpr int kMostSegments = 400;        // more segments take minutes
constexpr double kLeastOrder = 0.5;
constexpr double kAsHardAsHair = 0.3;  // times hair's EA, from which on stretching is left out

std::string why_not(const Problem& problem) {
  if (problem.is_toy()) return "a toy is no continuum";
  const StrandStart& start = problem.scene.hair.strands[0];
  if (start.strand.segments() < 1) return "a strand of one particle is no continuum";
  if (start.rest_curvature.size() > 0) return "a strand that rests curved can't be divided anew";
  if (times_the_ea_of_hair(start.strand) < kAsHardAsHair)
    return "to follow how so soft a strand stretches through the finest segments may take minutes";
  if (!starts_rigid(problem))
    return "a strand that starts stretched or compressed rings, and to follow that through the finest takes "
           "minutes";
  return "";
}

// The positions at the arc lengths `wanted`, for all moments after the start, in one column. `at`: the
// particles' arc lengths.
Eigen::VectorXd places_of(const Trajectory& states, const Eigen::VectorXd& at,
                          const Eigen::VectorXd& wanted) {
  const Eigen::Index moments = static_cast<Eigen::Index>(states.size()) - 1, size = 3 * wanted.size();
  Eigen::VectorXd places(moments * size);
  for (Eigen::Index k = 0; k < moments; ++k)
    places.segment(k * size, size) = points_at(states[k + 1].x, at, wanted);
  return places;
}

std::optional<SpaceError> divided_ever_finer(const Problem& problem, const std::atomic<bool>& interrupted) {
  SpaceError result;
  result.left_out = why_not(problem);
  if (!result.left_out.empty()) return result;

  const StrandStart& start = problem.scene.hair.strands[0];
  const int own = start.strand.segments(), base = own % 2 == 0 ? own / 2 : own;
  if (base << (kLevels - 1) > kMostSegments) {
    result.left_out = "strands of so many segments, divided further, take minutes";
    return result;
  }
  const double began = timing::cpu_seconds();
  const Eigen::VectorXd wanted = arc_lengths(divide_anew(start, base).strand).tail(base);
  const auto move = [&](int segments, double tolerance) -> std::optional<Eigen::VectorXd> {
    Problem divided = problem;
    divided.scene.hair.strands[0] = divide_anew(start, segments);
    RigidStrandOde ode(divided);
    const auto run =
        run_cvode(ode, problem.duration, problem.scene.frames, {CvodeMethod::adams, tolerance}, interrupted);
    if (!run) return {};
    result.stretch = std::max(result.stretch, ode.stretch());
    return places_of(run->states, arc_lengths(divided.scene.hair.strands[0].strand), wanted);
  };

  std::vector<Eigen::VectorXd> places;
  for (int level = 0; level < kLevels; ++level) {
    auto moved = move(base << level, kTolerance);
    if (!moved) return {};
    places.push_back(std::move(*moved));
  }
  const auto other = move(base << (kLevels - 2), kOtherTolerance);
  if (!other) return {};

  const Eigen::VectorXd &finest = places[3], &second = places[2], &third = places[1];
  result.time_error = largest_distance(second, *other);
  result.order = std::log2(largest_distance(third, second) / largest_distance(second, finest));
  result.cpu_seconds = timing::cpu_seconds() - began;
  if (!(result.order >= kLeastOrder)) {
    result.left_out =
        "more segments lead to no limit, or to none that is in sight yet: so it is with a strand that starts "
        "with a kink";
    return result;
  }
  const Eigen::VectorXd limit = finest + (finest - second) / (std::exp2(result.order) - 1);
  for (int level = 0; level < kLevels; ++level)
    result.levels.push_back({base << level, largest_distance(places[level], limit)});
  return result;
}

}  // namespace

std::optional<double> SpaceError::error_of(int segments) const {
  for (const SpaceLevel& level : levels)
    if (level.segments == segments) return level.error;
  return {};
}

std::optional<SpaceError> space_error(const Problem& problem, const std::atomic<bool>& interrupted) {
  try {
    return divided_ever_finer(problem, interrupted);
  } catch (const std::exception& error) {
    SpaceError none;
    none.left_out = printable(error.what());
    return none;
  }
}

}  // namespace hair
