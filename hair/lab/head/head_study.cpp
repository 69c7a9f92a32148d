#include "hair/lab/head/head_study.h"

#include <memory>
#include <numeric>

#include "hair/groom/farthest_points.h"
#include "solver/timing.h"

namespace hair::head_study {
namespace {

// The roots of `guides` strands that are well spread: ascending indices. All of them if there are no more.
std::vector<std::size_t> choose_guides(const GrownHead& head, int guides) {
  std::vector<Vector3d> places;
  places.reserve(head.roots.size());
  for (const RootFrame& root : head.roots) places.push_back(root.position);
  return farthest_points(places, static_cast<std::size_t>(guides));
}

class GuidedHead {
 public:
  GuidedHead(const GrownHead& head, const std::vector<std::size_t>& which, const MovingHeadSettings& settings)
      : guides_(head, which, settings) {
    run_.guides = static_cast<int>(which.size());
    SynthesisDescription description;
    for (const std::size_t k : which) description.guides.push_back(head.roots[k]);
    description.children = head.roots;
    description.points = head.hair->points;
    for (const ModeName& mode : kModes) {
      description.mode = mode.mode;
      synthesis_.push_back(std::make_unique<Synthesis>(description));
      tallies_.emplace_back(head.hair->points);
    }
  }

  const GuideRun& run() const { return run_; }

  void advance(bool counts) {
    const double took = guides_.advance();
    if (counts) run_.simulation += took;
  }

  // Makes strands by synthesis into `made`, and compares them with the simulated ones.
  void compare(const ScalpTurn& turn, std::span<const double> simulated, bool counts, const SeeHead& see,
               std::span<double> made) {
    const std::span<const double> guides = guides_.points();
    for (std::size_t m = 0; m < kModes.size(); ++m) {
      const double begin = timing::process_cpu_seconds();
      synthesis_[m]->make(guides, turn, {}, made);
      if (counts) run_.modes[m].synthesis += timing::process_cpu_seconds() - begin;
      tallies_[m].add(made, simulated, turn);
      run_.modes[m].errors = tallies_[m].errors();
      if (see && kModes[m].mode == SynthesisMode::interpolate) see(run_.guides, made);
    }
  }

 private:
  GuideRun run_;
  MovingHead guides_;
  std::vector<std::unique_ptr<Synthesis>> synthesis_;  // one for each mode, as are the tallies
  std::vector<HeadErrorTally> tallies_;
};

}  // namespace

std::optional<HeadCase> study_head(const std::shared_ptr<const Bust>& bust, const GrownHead& head,
                                   const HeadStudySettings& settings, const std::atomic<bool>& interrupted,
                                   const std::function<void(const std::string&)>& say, const SeeHead& see) {
  HeadCase result{head.hair, settings.collides, static_cast<int>(head.strands.size()), head.length, 0, {}};
  const std::string name = head.hair->title + (settings.collides ? ", on a head" : ", without a head");
  say(name);
  const MovingHeadSettings moving{bust, settings.collides};
  std::vector<std::size_t> all(head.strands.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  MovingHead every(head, all, moving);
  std::vector<std::unique_ptr<GuidedHead>> guided;
  for (const int guides : settings.guides)
    if (guides <= result.strands)
      guided.push_back(std::make_unique<GuidedHead>(head, choose_guides(head, guides), moving));

  std::vector<double> made(3 * all.size() * head.hair->points);
  const Motion motion = turn_of_head();
  for (int frame = 0; frame <= kSettle + kMoving; ++frame) {
    const bool counts = frame > kSettle;
    if (interrupted) return {};
    say(name + ", frame " + std::to_string(frame) + " of " + std::to_string(kSettle + kMoving));
    if (frame > 0) {
      const double took = every.advance();
      if (counts) result.seconds += took;
      for (const auto& one : guided) one->advance(counts);
    }
    if (frame < kSettle) continue;
    const std::span<const double> simulated = every.points();
    const SeeHead& seen = frame == kPictured ? see : nullptr;
    if (seen) seen(result.strands, simulated);
    const ScalpTurn turn = way_at(motion, frame / kFramesPerSecond).rotation.toRotationMatrix();
    for (const auto& one : guided) one->compare(turn, simulated, counts, seen, made);
  }
  for (const auto& one : guided) result.runs.push_back(one->run());
  return result;
}

}  // namespace hair::head_study
