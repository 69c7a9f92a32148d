// STAFF ONLY. Computes a part's reference solution, by CVODE or with many steps.
#include "grader/judge/study/truth.h"

#include <Eigen/Geometry>
#include <stdexcept>

#include "grader/compile/hash.h"
#include "hair/scene/scene_run.h"
#include "hair/truth/motion_cache.h"
#include "hair/truth/trajectory.h"

namespace grader::inline judge {
namespace {

namespace fs = std::filesystem;

constexpr int kTimesFinest = 32;

std::vector<particles::State> played(const StudiedPart& part, const TimeGrid& grid) {
  const SceneText text = on_grid(part, grid);
  const hair::Scene scene = hair::parse_scene(text.json, text.name);
  hair::SceneRun scene_run(scene);
  std::vector<particles::State> frames = {scene_run.state()};
  for (int k = 0; k < scene.frames; ++k) {
    if (const auto trouble = scene_run.advance())
      throw std::runtime_error("the reference breaks in " + part.name + ": " + *trouble);
    frames.push_back(scene_run.state());
  }
  return frames;
}

hair::AccurateMotion by_many_steps(const StudiedPart& part) {
  TimeGrid finest = grids_of(part.scene).back();
  finest.steps_per_frame *= kTimesFinest / 2;
  const std::vector<particles::State> half = played(part, finest);
  finest.steps_per_frame *= 2;
  hair::AccurateMotion motion;
  motion.states = played(part, finest);
  motion.agreement = hair::largest_distance(half, motion.states);
  motion.method = "our own run in " + std::to_string(finest.steps()) + " steps";
  return motion;
}

// CVODE computes one strand or one toy without contacts, if it can.
std::optional<hair::AccurateMotion> by_cvode(const StudiedPart& part, const std::optional<fs::path>& kept) {
  const hair::Scene& scene = part.scene;
  if (!hair::have_accurate_motion() || !scene.hair.obstacles.empty() || scene.hair.strands.size() > 1)
    return {};
  try {
    hair::ProblemSettings settings;
    settings.duration = scene.frames / scene.frames_per_second;
    hair::Problem problem = hair::make_problem(scene, settings);
    problem.scene.frames = scene.frames;  // are the moments
    problem.scene.frames_per_second = scene.frames_per_second;
    problem.scene.hair.step = 1 / scene.frames_per_second;
    return hair::accurate_motion(problem, {.cache = kept}, std::atomic<bool>(false));
  } catch (const std::runtime_error&) {  // CVODE gave up, or knows no such problem
    return {};
  }
}

hair::AccurateMotion kept_or_made(const StudiedPart& part, const std::optional<fs::path>& kept) {
  if (std::optional<hair::AccurateMotion> motion = by_cvode(part, kept)) return *std::move(motion);
  if (!kept) return by_many_steps(part);
  const std::string key = "our own run of " + sha256(part.json);
  if (std::optional<hair::AccurateMotion> motion = hair::find_motion(*kept, key)) return *std::move(motion);
  hair::AccurateMotion motion = by_many_steps(part);
  hair::keep_motion(*kept, key, motion);
  return motion;
}

}  // namespace

Truth true_motion(const StudiedPart& part, const std::optional<fs::path>& kept) {
  Truth truth{kept_or_made(part, kept)};
  Eigen::AlignedBox3d box;
  for (const particles::State& state : truth.motion.states)
    for (Eigen::Index at = 0; at < state.x.size(); at += 3)
      box.extend(Eigen::Vector3d(state.x.segment<3>(at)));
  truth.size = box.diagonal().norm();
  return truth;
}

}  // namespace grader::judge
