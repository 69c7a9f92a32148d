// STAFF ONLY. The scenes of a study, their parts with fewer and with more steps, and their reference
// solutions, by CVODE or with many steps.
#include "grader/judge/study/scenes.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "grader/compile/hash.h"
#include "grader/judge/run/play_scene.h"
#include "hair/truth/accurate_motion.h"

namespace grader::inline judge {
namespace {

using nlohmann::json;

constexpr int kFewestFrames = 3;
constexpr int kCoarser = 5, kFinerHair = 4,
              kFinerToy = 3;  // multiply the steps; toys have many already

struct Known {
  const char* name;
  int order;
};

Known known(hair::Method method) {
  const hair::MethodRow& row = hair::row_of(method);
  return {row.name, row.order};
}

Known known(hair::ToyMethod method) {
  for (const hair::MethodRow& row : hair::methods())
    if (row.toy == method) return {row.name, row.order};
  return {"", 1};
}

StudiedPart part_of(const json& scene, const std::string& name) {
  StudiedPart part{name, scene.dump(), {}, 1};
  part.scene = hair::parse_scene(part.json, name);
  const Known method =
      part.scene.toys.empty() ? known(part.scene.hair.method) : known(part.scene.toys.front().method);
  part.name += std::string(", ") + method.name;
  part.order = method.order;
  return part;
}

// One double pendulum by each of four methods.
json pendulums() {
  json scene = json::parse(R"({
  "shows": "one double pendulum, four integrators",
  "frames": 12, "frames_per_second": 25, "steps_per_frame": 40
})");
  for (const char* method : {"forward_euler", "symplectic_euler", "midpoint", "runge_kutta_4"}) {
    json toy = json::parse(R"({
  "particles": [
    {"position": [0, 0, 0], "mass": 1, "pinned": true},
    {"position": [0.4, 0, -0.3], "mass": 0.3},
    {"position": [0.4, 0, -0.7], "mass": 0.2}
  ],
  "springs": [
    {"between": [0, 1], "stiffness": 400, "rest_length": 0.5, "damping": 0.1},
    {"between": [1, 2], "stiffness": 300, "rest_length": 0.5, "damping": 0.1}
  ]
})");
    toy["method"] = method;
    scene["toys"].push_back(std::move(toy));
  }
  return scene;
}

}  // namespace

const std::vector<SceneText>& studied_scenes() {
  static const std::vector<SceneText> scenes = {
      {"pendulums", pendulums().dump()},
      {"bead-on-wire", R"({
  "shows": "a bead on a wire, and two rods",
  "frames": 12, "frames_per_second": 25, "steps_per_frame": 20,
  "toys": [{
    "particles": [
      {"position": [0.8, 0, -0.6], "mass": 0.5},
      {"position": [1.2, 0, -0.6], "mass": 0.2},
      {"position": [1.2, 0.4, -0.6], "mass": 0.1}
    ],
    "rods": [{"between": [0, 1], "length": 0.4}, {"between": [1, 2], "length": 0.4}],
    "wires": [{"particle": 0, "centre": [0, 0, 0], "normal": [0, 1, 0], "radius": 1}],
    "feedback": {"stiffness": 400, "damping": 40}
  }]
})"},
      {"stiff-swing", R"({
  "shows": "a stiff hair, its root pulled aside",
  "frames": 12, "frames_per_second": 120, "steps_per_frame": 2,
  "method": "implicit_euler", "preconditioner": "none",
  "hair": [{
    "segments": 10, "length": 0.1,
    "material": {"stretch_factor": 10},
    "roots": {"list": [{"position": [0, 0, 0], "direction": [0, 0, -1]}]},
    "root_velocity": [0.5, 0, 0]
  }]
})"},
      {"skip-springs", R"({
  "shows": "a hair with springs that skip a particle",
  "frames": 12, "frames_per_second": 120, "steps_per_frame": 2,
  "method": "implicit_euler",
  "hair": [{
    "segments": 8, "length": 0.08, "clamped": false,
    "material": {"bend_factor": 0, "skip_factor": 0.2},
    "roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]}
  }]
})"},
      {"strand-swing", R"({
  "shows": "a hair swings down",
  "frames": 12, "frames_per_second": 60, "steps_per_frame": 4,
  "hair": [{
    "segments": 10, "length": 0.1, "clamped": false,
    "roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]}
  }]
})"},
      {"curly-hair", R"({
  "shows": "a curl sags under its weight",
  "frames": 12, "frames_per_second": 80, "steps_per_frame": 3,
  "method": "implicit_euler",
  "hair": [{
    "segments": 9, "length": 0.06,
    "material": {"young_modulus": 1e8},
    "shape": {"curly": {"radius": 0.006, "pitch": 0.015}},
    "roots": {"list": [{"position": [0, 0, 0], "direction": [0, 0, -1]}]},
    "root_velocity": [0, 0.3, 0]
  }]
})"},
      {"strand-over-sphere", R"({
  "shows": "two hairs fall over a head",
  "frames": 12, "frames_per_second": 80, "steps_per_frame": 3,
  "hair": [{
    "segments": 10, "length": 0.12, "clamped": false,
    "roots": {"list": [
      {"position": [-0.04, -0.01, 0.07], "direction": [1, 0, 0]},
      {"position": [-0.04, 0.02, 0.07], "direction": [1, 0, 0]}
    ]}
  }],
  "obstacles": [{"sphere": {"centre": [0, 0, 0], "radius": 0.06}, "friction": 0.3}]
})"},
  };
  return scenes;
}

std::vector<StudiedPart> parts_of(const SceneText& text) {
  const json scene = json::parse(text.json);
  if (!scene.contains("toys")) return {part_of(scene, text.name)};
  std::vector<StudiedPart> parts;
  for (const json& toy : scene["toys"]) {
    json one = scene;
    one["toys"] = json::array({toy});
    parts.push_back(part_of(one, text.name));
  }
  return parts;
}

SceneText on_grid(const StudiedPart& part, const TimeGrid& grid) {
  json scene = json::parse(part.json);
  scene["frames"] = grid.frames;
  scene["frames_per_second"] = grid.frames * part.scene.frames_per_second / part.scene.frames;
  scene["steps_per_frame"] = grid.steps_per_frame;
  return {part.name, scene.dump()};
}

std::vector<TimeGrid> grids_of(const hair::Scene& scene) {
  std::vector<TimeGrid> all = {{scene.frames, scene.steps_per_frame}};
  for (int k = 0; k < kCoarser; ++k) {
    TimeGrid coarser = all.front();
    if (coarser.steps_per_frame % 2 == 0)
      coarser.steps_per_frame /= 2;
    else if (coarser.frames % 2 == 0 && coarser.frames / 2 >= kFewestFrames)
      coarser.frames /= 2;
    else
      break;
    all.insert(all.begin(), coarser);
  }
  for (int k = 0; k < (scene.toys.empty() ? kFinerHair : kFinerToy); ++k)
    all.push_back({scene.frames, all.back().steps_per_frame * 2});
  return all;
}

std::vector<TimeGrid> between(const TimeGrid& coarse) {
  std::vector<TimeGrid> all;
  for (int steps = coarse.steps_per_frame + 1; steps < 2 * coarse.steps_per_frame; ++steps)
    all.push_back({coarse.frames, steps});
  return all;
}

namespace {

namespace fs = std::filesystem;

constexpr int kTimesFinest = 32;

std::vector<particles::State> played(const StudiedPart& part, const TimeGrid& grid) {
  const SceneText text = on_grid(part, grid);
  Played run;
  play_scene(hair::parse_scene(text.json, text.name), run);
  if (!run.trouble.empty())
    throw std::runtime_error("the reference breaks in " + part.name + ": " + run.trouble);
  return std::move(run.frames);
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
