// STAFF ONLY. The warnings of a scene's run, with the reference: for scenes whose numbers are finite and
// wrong, and for none of the shipped ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <set>

#include "hair/scene/scene_run.h"

namespace reference_tests {
namespace {

using hair::Concern;
using hair::Scene;
using hair::Watch;

constexpr int kFewStrands = 100;

// Keeps some of a scene's strands, evenly chosen.
void thin_out(Scene& scene) {
  if (scene.hair.mesh) return;  // its strands are one system
  std::vector<hair::StrandStart>& all = scene.hair.strands;
  const std::size_t every = (all.size() + kFewStrands - 1) / kFewStrands;
  if (every < 2) return;
  std::vector<hair::StrandStart> some;
  for (std::size_t i = 0; i < all.size(); i += every) some.push_back(all[i]);
  for (hair::Rider& rider : scene.riders) {
    std::vector<int> strands;
    for (int strand : rider.strands)
      if (strand % static_cast<int>(every) == 0) strands.push_back(strand / static_cast<int>(every));
    rider.strands = strands;
  }
  all = some;
}

Watch play(const Scene& scene) {
  hair::SceneRun scene_run(scene);
  for (int k = 0; k < scene.frames; ++k)
    if (const auto trouble = scene_run.advance()) {
      ADD_FAILURE() << scene.name << ": " << *trouble;
      break;
    }
  return scene_run.watch();
}

// Scenes that must warn, as their rows in hair/scenes/README.md say.
bool shall_warn(const std::string& scene, Concern concern) {
  if (scene == "extreme")
    return concern == Concern::loss || concern == Concern::unmoved || concern == Concern::energy;
  if (scene == "crushed-hair") return concern == Concern::loss || concern == Concern::unmoved;
  return scene == "pendulum" && concern == Concern::energy;
}

TEST(Watch, NoOtherShippedSceneWarns) {
  int watched = 0;
  for (const auto& file : std::filesystem::directory_iterator(HAIR_SCENES)) {
    if (file.path().extension() != ".json") continue;
    Scene scene = hair::read_scene(file.path());
    ++watched;
    thin_out(scene);
    hair::SceneRun scene_run(scene);
    double stretch = 0;
    for (int k = 0; k < scene.frames; ++k) {
      ASSERT_FALSE(scene_run.advance()) << scene.name;
      stretch = std::max(stretch, scene_run.measure(scene_run.state()).stretch);
    }
    bool any = false;
    for (const hair::Warning& one : scene_run.warnings()) {
      EXPECT_TRUE(shall_warn(scene.name, one.concern->concern))
          << scene.name << ": " << one.concern->id << " " << one.size;
      any = true;
    }
    EXPECT_EQ(any, std::set<std::string>({"crushed-hair", "extreme", "pendulum"}).contains(scene.name))
        << scene.name;
    EXPECT_TRUE(any || stretch <= 0.01 || scene.shows.find("stretch") != std::string::npos)
        << scene.name << " stretches by " << stretch << ", and does not say so";
    std::cout << scene.name << ": stretch " << stretch;
    for (const hair::ConcernRow& row : hair::concerns())
      if (const double size = scene_run.watch().worst(row.concern); size > 0)
        std::cout << ", " << row.id << " " << size;
    std::cout << "\n";
  }
  EXPECT_GE(watched, 20);
}

// A level hair, with these keys of the hair and of the scene.
Scene one_hair(const std::string& of_hair, const std::string& keys) {
  return hair::parse_scene(R"({"shows": "a level hair", "hair": [{)" + of_hair +
                               R"("roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]}}], )" +
                               keys + "}",
                           "scene");
}

// The same for 30 cm in 30 segments.
Scene level_hair(const std::string& keys, const std::string& of_hair = "") {
  return one_hair(R"("segments": 30, "length": 0.3, )" + of_hair, keys);
}

constexpr const char* kHinge = R"("clamped": false, )";

void expect_warns(const Scene& scene, const std::set<Concern>& expected) {
  const Watch watch = play(scene);
  std::set<Concern> warned;
  for (const hair::Warning& warning : watch.warnings()) {
    warned.insert(warning.concern->concern);
    EXPECT_EQ(warning.strand, 0);
    EXPECT_GE(warning.step, 1);
    EXPECT_LE(warning.step, static_cast<long>(scene.frames) * scene.steps_per_frame);
    EXPECT_EQ(warning.strands, 1);
    EXPECT_GT(warning.size, warning.concern->bound);
    EXPECT_EQ(warning.size, watch.worst(warning.concern->concern));
  }
  for (Concern concern : expected)
    EXPECT_TRUE(warned.count(concern))
        << hair::concerns()[static_cast<std::size_t>(concern)].id << ": " << watch.worst(concern);
}

TEST(Watch, WarnsOfLevelHairThatIsNotRight) {
  const auto sphere = [](const char* x, const char* z, const char* radius) {
    return std::string(R"({"sphere": {"centre": [)") + x + ", 0, " + z + R"(], "radius": )" + radius + "}}";
  };
  const struct {
    const char* what;
    std::string keys, of_hair;
    std::set<Concern> expected;
  } rows[] = {
      {"inside an obstacle at the start",
       R"("frames": 10, "obstacles": [)" + sphere("0.1", "0", "0.05") + "]",
       kHinge,
       {Concern::contact_energy}},
      {"its root is inside an obstacle, and is mended without end",
       R"("frames": 10, "obstacles": [)" + sphere("0", "-0.02", "0.05") + "]",
       kHinge,
       {Concern::contact_energy, Concern::stretch, Concern::mends}},
      {"obstacles leave no room",
       R"("frames": 1, "steps_per_frame": 1, "method": "implicit_euler", "obstacles": [)" +
           sphere("0.2", "0.07", "0.08") + ", " + sphere("0.2", "-0.07", "0.08") + "]",
       kHinge,
       {Concern::penetration}},
      {"falls in long steps",
       R"("frames": 30, "frames_per_second": 60, "steps_per_frame": 1, "method": "implicit_euler")",
       R"("clamped": false, "material": {"bend_factor": 1e-3}, )",
       {Concern::segment}},
      {"too stiff to move",
       R"("frames": 30, "steps_per_frame": 1, "method": "implicit_euler")",
       R"("clamped": false, "material": {"stretch_factor": 1e6}, )",
       {Concern::stretching}},
      {"velocities that stretch",
       R"("frames": 5, "drag": 1e6, "wind": [1e6, 0, 0])",
       "",
       {Concern::stretch_rate}},
      {"velocities of hair that stands still",
       R"("frames": 30, "drag": 1e6, "wind": [1, 0, 0])",
       "",
       {Concern::unmoved}},
      {"energy from nowhere", R"("frames": 10, "gravity": [0, 0, -1e6])", kHinge, {Concern::energy}},
      {"energy of long steps",
       R"("frames": 10, "frames_per_second": 0.1, "steps_per_frame": 1)",
       kHinge,
       {Concern::energy}},
  };
  for (const auto& [what, keys, of_hair, expected] : rows) {
    SCOPED_TRACE(what);
    expect_warns(level_hair(keys, of_hair), expected);
  }
}

// Velocities are those at a step's end, and displacements are those of its middle.
TEST(Watch, DoesNotWarnOfHairThatGetsFaster) {
  for (
      const char* keys :
      {R"("frames": 30, "gravity": [0, 0, 0], "drag": 1e-4, "wind": [0, 1, 0])",
       R"("frames": 60, "frames_per_second": 60, "steps_per_frame": 1, "obstacles": [{"sphere": {"centre": [0.12, 0, -0.1],
           "radius": 0.09}, "friction": 0.3}])"}) {
    SCOPED_TRACE(keys);
    const Watch watch = play(level_hair(keys, kHinge));
    EXPECT_TRUE(watch.warnings().empty()) << watch.worst(Concern::unmoved);
  }
}

TEST(Watch, WarnsOfFrictionThatHoldsHairInItsStretch) {
  const Scene scene =
      hair::parse_scene(R"({"shows": "falls on a sphere", "frames": 60, "method": "implicit_euler",
    "hair": [{"segments": 24, "length": 0.3, "clamped": false,
              "roots": {"list": [{"position": [-0.12, 0, 0.1], "direction": [1, 0, 0]}]}}],
    "obstacles": [{"sphere": {"centre": [0, 0, 0], "radius": 0.09}, "friction": 1000}]})",
                        "scene");
  expect_warns(scene, {Concern::stretching});
}

TEST(Watch, WarnsOfCurlsInLargeSteps) {
  const auto curls = [](const std::string& method) {  // 20 turns
    return one_hair(
        R"("segments": 160, "length": 0.3, "shape": {"curly": {"radius": 0.005, "pitch": 0.0125}}, )",
        R"("steps_per_frame": 1, "frames": 30, "method": ")" + method + "\"");
  };
  expect_warns(curls("predictor_corrector"), {Concern::energy});
  // H4 is right if its solves end.
  EXPECT_TRUE(play(curls("implicit_euler")).warnings().empty());
}

TEST(Watch, WarnsOfHelicesThatGainEnergyAndNotOfLinks) {
  for (const char* material : {"", R"("material": {"joint_limit": 20}, )"})
    for (const char* steps : {"1", "8"})
      EXPECT_TRUE(play(level_hair(R"("frames": 60, "steps_per_frame": )" + std::string(steps),
                                  R"("model": "rigid_links", )" + std::string(material)))
                      .warnings()
                      .empty())
          << material << steps;
  const std::string soft = R"("model": "super_helix", "segments": 6, "length": 0.3, "material":
    {"bend_factor": 1e-4, "twist_factor": 1e-4}, )";
  expect_warns(one_hair(soft, R"("frames": 90, "steps_per_frame": 1)"), {Concern::energy});
  EXPECT_TRUE(play(one_hair(soft, R"("frames": 30, "steps_per_frame": 64)")).warnings().empty());
}

TEST(Watch, WarnsOfASpinThatStepsDoNotResolve) {
  const auto spin = [](const std::string& rate) {
    return one_hair(R"("segments": 20, "length": 0.2, "clamped": false, "start": {"direction": [1, 0, 0],
      "spin": [0, 0, )" +
                        rate + "]}, ",
                    R"("frames": 30, "gravity": [0, 0, 0])");
  };
  expect_warns(spin("1000"), {Concern::loss});
  EXPECT_TRUE(play(spin("1")).warnings().empty());
}

// A step of forward Euler with a stiffness near its limit: toys are watched as hair is.
TEST(Watch, WarnsOfToys) {
  const Scene scene =
      hair::parse_scene(R"({"shows": "a swing", "frames": 60, "toys": [{"method": "forward_euler",
    "particles": [{"position": [0, 0, 0], "mass": 1, "pinned": true}, {"position": [0.5, 0, 0], "mass": 1}],
    "rods": [{"between": [0, 1]}]}]})",
                        "scene");
  hair::SceneRun scene_run(scene);
  for (int k = 0; k < scene.frames; ++k) ASSERT_FALSE(scene_run.advance());
  const std::vector<hair::Warning> warnings = scene_run.warnings();
  ASSERT_FALSE(warnings.empty());
  EXPECT_EQ(warnings[0].body, "toy");
}

// A tolerance that rounding does not allow fails at nearly each step.
TEST(Watch, WarnsOfSolvesThatDoNotEnd) {
  const Scene scene = level_hair(
      R"("frames": 40, "steps_per_frame": 1, "method": "implicit_euler", "preconditioner": "none", "tolerance": 1e-15)");
  expect_warns(scene, {Concern::solves});
  hair::SceneRun scene_run(scene);
  long first = 0;
  for (int k = 1; k <= scene.frames; ++k) {
    ASSERT_FALSE(scene_run.advance());
    if (first == 0 && scene_run.work().unconverged > 0) first = k;
  }
  EXPECT_EQ(scene_run.work().solves, scene.frames);
  for (const hair::Warning& one : scene_run.warnings()) {
    if (one.concern->concern != Concern::solves) continue;
    EXPECT_EQ(one.step, first);
    EXPECT_EQ(one.solver, "H4");
  }
}

// Redundant rods without forces do not move.
TEST(Watch, RedundantRodsRest) {
  const std::string square = R"({"shows": "a braced square", "frames": 60, "gravity": [0, 0, 0],
      "toys": [{"particles": [{"position": [0, 0, 0], "mass": 0.1}, {"position": [0.2, 0, 0], "mass": 0.1},
        {"position": [0.2, 0, -0.2], "mass": 0.1}, {"position": [0, 0, -0.2], "mass": 0.1}],
        "rods": [{"between": [1, 0]}, {"between": [2, 0]}, {"between": [2, 1]}, {"between": [3, 0]},
          {"between": [3, 1]}, {"between": [3, 2]}],
        "feedback": {"stiffness": 400, "damping": 40}, "method": )";
  for (const char* method : {"\"forward_euler\"", "\"midpoint\"", "\"runge_kutta_4\""}) {
    const Scene scene = hair::parse_scene(square + method + "}]}", "scene");
    hair::SceneRun scene_run(scene);
    const Eigen::VectorXd start = scene_run.state().x;
    for (int k = 0; k < scene.frames; ++k) ASSERT_FALSE(scene_run.advance());
    EXPECT_TRUE(scene_run.warnings().empty());
    EXPECT_LE((scene_run.state().x - start).norm(), 1e-12) << method;  // rounding, in 480 steps
  }
}

// A root that flies past a sphere pulls its hair into it, 40 cm in a step.
TEST(Watch, FastHairMeetsASphereInItsWay) {
  Scene scene = level_hair(R"("frames": 5, "method": "implicit_euler",
    "obstacles": [{"sphere": {"centre": [0.06, 0.6, 0], "radius": 0.05}}])",
                           R"("clamped": false, "root_velocity": [0, 100, 0], )");
  hair::SceneRun scene_run(scene);
  for (int k = 0; k < scene.frames; ++k) ASSERT_FALSE(scene_run.advance());
  EXPECT_GT(scene_run.work().contacts, 0);
}

}  // namespace
}  // namespace reference_tests
