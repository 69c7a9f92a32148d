#include "hair/truth/accurate_motion.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <tuple>

#include "hair/io/files/bad_input.h"
#include "hair/io/plot/page.h"
#include "hair/truth/cvode.h"
#include "hair/truth/motion_cache.h"
#include "hair/truth/rigid_strand_ode.h"
#include "hair/truth/strand_ode.h"
#include "hair/truth/toy_ode.h"
#include "particles/require.h"
#include "solver/timing.h"

namespace hair {

namespace {

// A full matrix that is larger costs more than all the rest.
constexpr double kLargestMatrix = 2e5;  // entries

using Ways = std::array<CvodeWay, 2>;

// The two ways differ as much as CVODE allows; if Newton's method would be too expensive, they are two
// tolerances.
Ways ways_for(const Ode& ode, double tolerance) {
  const double entries = static_cast<double>(ode.size()) * (ode.above() + 1 + ode.below());
  if (entries > kLargestMatrix)
    return {{{CvodeMethod::adams, tolerance}, {CvodeMethod::adams, 10 * tolerance}}};
  return {{{CvodeMethod::adams, tolerance}, {CvodeMethod::bdf, tolerance}}};
}

std::string name_of(const CvodeWay& way) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%s at %.2g", way.method == CvodeMethod::bdf ? "BDF" : "Adams",
                way.tolerance);
  return text.data();
}

bool moves_as_rigid(const Problem& problem) {
  if (problem.is_toy()) return false;
  const Strand& strand = problem.scene.hair.strands[0].strand;
  return strand.segments() > 0 && times_the_ea_of_hair(strand) > kHardToStretch && starts_rigid(problem);
}

std::unique_ptr<Ode> ode_of(const Problem& problem) {
  if (problem.is_toy()) return std::make_unique<ToyOde>(problem);
  if (moves_as_rigid(problem)) return std::make_unique<RigidStrandOde>(problem);
  return std::make_unique<StrandOde>(problem);
}

// The distance of a stretching strand from the limit, over the largest stretch by its tensions: 1.0 to 1.6
// for a released strand, 2.4 for a moving root. It is not derived, so the factor is larger.
constexpr double kOfStretch = 4;

}  // namespace

double AccurateMotion::least_error() const {
  return std::max(agreement, kLeastError);
}

bool have_accurate_motion() {
  return have_cvode();
}

std::optional<AccurateMotion> accurate_motion(const Problem& problem, const AccurateSettings& settings,
                                              const std::atomic<bool>& interrupted) {
  particles::require_positive("the tolerance of an accurate motion", settings.tolerance);
  const std::unique_ptr<Ode> ode = ode_of(problem);
  const Ways ways = ways_for(*ode, std::max(settings.tolerance, kTightest));
  const auto* rigid = dynamic_cast<const RigidStrandOde*>(ode.get());

  AccurateMotion motion;
  motion.inextensible = rigid != nullptr;
  motion.method = "CVODE " + cvode_version() + ": " + name_of(ways[0]) + ", beside " + name_of(ways[1]) +
                  (rigid ? ", of rigid segments" : "");
  std::string key;
  if (settings.cache) {
    // Equations of its own, because equations that were solved keep a memory.
    key = motion_key(problem, *ode_of(problem),
                     motion.method + ", exactly " + to_exact_text(ways[0].tolerance));
    if (auto kept = find_motion(*settings.cache, key)) return kept;
  }

  const double start = timing::cpu_seconds();
  std::array<Trajectory, std::tuple_size_v<Ways>> found;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    std::optional<CvodeRun> run =
        run_cvode(*ode, problem.duration, problem.scene.frames, ways[k], interrupted);
    if (!run) return {};
    motion.evaluations += run->evaluations;
    found[k] = std::move(run->states);
  }
  motion.cpu_seconds = timing::cpu_seconds() - start;
  motion.agreement = largest_distance(found[0], found[1]);
  if (rigid) motion.agreement = std::max(motion.agreement, kOfStretch * rigid->stretch());
  motion.states = std::move(found[0]);
  if (settings.cache) {
    try {
      keep_motion(*settings.cache, key, motion);
    } catch (const BadInput&) {
      // A folder that can't be written costs time in the next run, and nothing now.
    }
  }
  return motion;
}

}  // namespace hair
