#include "hair/bench/head_parts.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "hair/scene/playback.h"
#include "solver/timing.h"

namespace hair_bench {
namespace {

using namespace hair;

constexpr int kTurns = 9, kFramesBefore = 12;  // frames
constexpr int kSteps = 8;                      // of a frame

struct Case {
  std::string name, scene;
};

struct Costs {
  const Scene scene;
  Playback playback;
  std::vector<double> seconds = {};

  explicit Costs(const Case& one) : scene(parse_scene(one.scene, one.name)), playback(scene) {
    for (int k = 0; k < kFramesBefore; ++k) playback.advance();
  }
  double particles() const { return static_cast<double>(playback.state().x.size()) / 3; }
};

// Turn by turn, so that what else the machine does meets all of them. The ratio is of medians, to the first case.
void compare(const char* title, const std::vector<Case>& cases) {
  std::vector<std::unique_ptr<Costs>> costs;
  for (const Case& one : cases) costs.push_back(std::make_unique<Costs>(one));
  std::vector<Work> before;
  for (const auto& one : costs) before.push_back(one->playback.work());
  for (int turn = 0; turn < kTurns; ++turn)
    for (const auto& one : costs) {
      const double start = timing::cpu_seconds();
      one->playback.advance();
      one->seconds.push_back(timing::cpu_seconds() - start);
    }
  std::printf("%s\n\n", title);
  std::puts(
      "| hair | ns for a particle's step | ratio | contacts a step | ConjGrad's steps a step | links | "
      "strips | ns for a link or strip |");
  std::puts("|---|--:|--:|--:|--:|--:|--:|--:|");
  const double first = timing::median(costs.front()->seconds);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Costs& one = *costs[i];
    const double time = timing::median(one.seconds), steps = kTurns * kSteps;
    const Work work = one.playback.work();
    const auto& mesh = one.scene.hair.mesh;
    const std::size_t links = mesh ? mesh->links.size() : 0, strips = mesh ? mesh->strips.size() : 0;
    std::printf("| %s | %.0f | %.2f | %.0f | %.0f | %zu | %zu | ", cases[i].name.c_str(),
                1e9 * time / kSteps / one.particles(), time / first,
                static_cast<double>(work.contacts - before[i].contacts) / steps,
                static_cast<double>(work.solver_steps - before[i].solver_steps) / steps, links, strips);
    if (links + strips > 0)
      std::printf("%.0f |\n", 1e9 * (time - first) / kSteps / static_cast<double>(links + strips));
    else
      std::puts("|");
  }
  std::puts("");
}

std::string scene_of(const std::string& hair, const std::string& more = "") {
  return R"({"shows": "a head", "frames": 100, "method": "implicit_euler", "drag": 2e-4, "hair": [)" + hair +
         "]" + more + "}";
}

std::string on_scalp(const std::string& shape = "") {
  return R"({"segments": 15, "length": 0.16, "roots": {"bust": {"count": 200, "lift": 0.1}})" + shape + "}";
}

// Ten rows of twenty hairs that hang, and are let go from one side.
std::string rows() {
  std::string all;
  for (int row = 0; row < 10; ++row) {
    const std::string y = std::to_string(0.008 * row);
    all += std::string(row > 0 ? ", " : "") +
           R"({"segments": 15, "length": 0.15, "start": {"direction": [0.3, 0.5, -1]},
      "roots": {"line": {"from": [0, )" +
           y + R"(, 0], "to": [0.152, )" + y + R"(, 0], "count": 20}}})";
  }
  return all;
}

}  // namespace

void head_parts() {
  const std::string curl = R"(, "shape": {"curly": {"radius": 0.004, "pitch": 0.04}})";
  const std::string ball =
      R"(, "obstacles": [{"sphere": {"centre": [0, 0.012, 0.02], "radius": 0.08}, "friction": 0.3}])";
  const std::string bust = R"(, "obstacles": [{"bust": {}, "friction": 0.3}])";
  compare("H4, 200 hairs of 16 particles on a scalp", {{"straight", scene_of(on_scalp())},
                                                       {"straight, a ball", scene_of(on_scalp(), ball)},
                                                       {"straight, a bust", scene_of(on_scalp(), bust)},
                                                       {"curls", scene_of(on_scalp(curl))},
                                                       {"curls, a ball", scene_of(on_scalp(curl), ball)},
                                                       {"curls, a bust", scene_of(on_scalp(curl), bust)}});
  const auto links = [](const std::string& more) {
    return R"(, "links": {"stiffness": 5e-4, "yields": 10, "breaks": 20)" + more + "}";
  };
  const std::string strips = R"(, "strips": {"thickness": 0.002, "stiffness": 0.02, "friction": 0.3})";
  compare("H4, 10 rows of 20 hairs of 16 particles",
          {{"nothing couples them", scene_of(rows())},
           {"links along rows", scene_of(rows(), links(""))},
           {"links both ways", scene_of(rows(), links(R"(, "neighbours": "both")"))},
           {"links and strips along rows", scene_of(rows(), links(strips))},
           {"links and strips both ways", scene_of(rows(), links(R"(, "neighbours": "both")" + strips))}});
}

}  // namespace hair_bench
