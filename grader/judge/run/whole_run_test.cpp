// STAFF ONLY. Tests that hidden scenes have the promised properties, and that wrong runs are found.
#include "grader/judge/run/whole_run.h"
#include "grader/judge/cases/suite_table.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <limits>

#include "grader/course/course.h"
#include "grader/course/input.h"
#include "grader/judge/run/play_scene.h"
#include "hair/dense/synthesis.h"
#include "solver/test_refusal.h"

namespace grader::inline judge {
namespace {

namespace fs = std::filesystem;
using tests::says;

const fs::path kScenes = HAIR_HIDDEN_SCENES;

HiddenScene hidden_scene_of(const std::string& exercise, const std::string& seed = "a seed") {
  return read_hidden_scene(kScenes / (exercise + ".json"), seed);
}

Played play(const hair::Scene& scene) {
  Played played;
  play_scene(scene, played);
  return played;
}

TEST(HiddenScene, EachExerciseWithPointsForItsRunHasOneThatCallsIt) {
  for (const Exercise& exercise : read_course(fs::path(HAIR_PROJECT) / "handout/exercises.json").exercises) {
    SCOPED_TRACE(exercise.id);
    const bool has_run = std::ranges::any_of(declared_categories(exercise.id),
                                             [](const auto& one) { return one.id == "WholeRun"; });
    ASSERT_EQ(has_run, fs::exists(kScenes / (exercise.id + ".json")));
    if (!has_run) continue;
    const HiddenScene hidden = hidden_scene_of(exercise.id);
    const std::vector<std::string> called = hair::exercises_of(hidden.scene);
    EXPECT_NE(std::find(called.begin(), called.end(), exercise.id), called.end());
    EXPECT_EQ(hidden.pictures.size(), kRunPictures);
  }
}

TEST(HiddenScene, IsAnotherForEachSeed) {
  EXPECT_EQ(hidden_scene_of("H2").text, hidden_scene_of("H2").text);
  const HiddenScene one = hidden_scene_of("H2"), other = hidden_scene_of("H2", "another seed");
  const Eigen::VectorXd a = one.scene.hair.strands[0].state.x, b = other.scene.hair.strands[0].state.x;
  EXPECT_NE(a, b);
  EXPECT_LE((a - b).norm(), 0.1 * a.norm());
}

TEST(HiddenScene, RefusesToVaryWhatIsNotThere) {
  const fs::path file = fs::temp_directory_path() / "hidden-scene-test.json";
  std::ofstream(file) << R"({"canary": "", "scene": {"shows": "a"}, "vary": {"/length": 1}, "pictures": []})";
  EXPECT_TRUE(
      says(tests::refusal<BadInput>([&] { read_hidden_scene(file, ""); }), "expected a JSON pointer to one"));
  fs::remove(file);
}

// Right solutions differ by roundings. A scene amplifies them, but a picture or an energy does not show them.
TEST(HiddenScene, AmplifiesRoundingsByLittle) {
  for (const fs::directory_entry& file : fs::directory_iterator(kScenes))
    for (const char* seed : {"a", "b", "c"}) {
      SCOPED_TRACE(file.path().stem().string() + ", seed " + seed);
      const HiddenScene hidden = read_hidden_scene(file.path(), seed);
      if (!hidden.scene.dense.empty()) continue;  // the reference alone moves H10's guides
      hair::Scene moved = hidden.scene;
      Random random(seed, "roundings");
      const auto move = [&](particles::State& state) {
        const double size = state.x.cwiseAbs().maxCoeff();
        for (double& entry : state.x) entry += 1e-13 * size * random.uniform(-1, 1);
      };
      for (hair::StrandStart& start : moved.hair.strands) move(start.state);
      for (hair::Toy& toy : moved.toys) move(toy.start);
      const RunComparison run = compare_runs(hidden.scene, hidden.pictures, play(moved));
      ASSERT_EQ(run.moments.size(), hidden.scene.frames + std::size_t{1});
      for (const Moment& moment : run.moments)
        EXPECT_LE(moment.apart, 1e-8 * run.size) << "at " << moment.time;
    }
}

// In thinner triangles the contract leaves weights open, and kDense would not follow from it.
TEST(HiddenScene, OfH10HasNoThinTriangles) {
  for (const hair::DenseHair& dense : hidden_scene_of("H10").scene.dense) {
    const std::vector<hair::RootFrame>& guides = dense.description.guides;
    const hair::Synthesis synthesis(dense.description);
    for (int child = 0; child < synthesis.children(); ++child) {
      std::array<Eigen::Vector3d, 3> corners;
      for (int k = 0; k < 3; ++k) corners[k] = guides[synthesis.parents(child).guides[k]].position;
      double longest = 0;
      for (int k = 0; k < 3; ++k) longest = std::max(longest, (corners[k] - corners[(k + 1) % 3]).norm());
      const double area = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
      EXPECT_GE(area / longest, 0.1 * longest) << "child " << child;
    }
  }
}

TEST(RunComparison, SeesDenseHair) {
  const HiddenScene hidden = hidden_scene_of("H10");
  Played played = play(hidden.scene);
  const RunComparison same = compare_runs(hidden.scene, hidden.pictures, played);
  ASSERT_EQ(same.shots.size(), 3U);
  for (const Shot& shot : same.shots) EXPECT_TRUE(shot.same);
  EXPECT_EQ(same.shots[0].student.strands.sizes.size(), 120U);

  played.dense[static_cast<std::size_t>(hidden.pictures[1])][7] += 2 * kDense * same.size;
  played.dense[static_cast<std::size_t>(hidden.pictures[2])][7] += 0.02 * same.size;
  const RunComparison moved = compare_runs(hidden.scene, hidden.pictures, played);
  EXPECT_EQ(moved.moments[1].dense_apart, 0);
  EXPECT_GT(moved.moments[static_cast<std::size_t>(hidden.pictures[1])].dense_apart, kDense * moved.size);
  EXPECT_TRUE(moved.shots[1].same) << "nobody can see it";
  EXPECT_FALSE(moved.shots[2].same);
  EXPECT_TRUE(moved.shots[2].far_off);
  EXPECT_EQ(same.their_motion, "");
  const auto theirs = nlohmann::json::parse(moved.their_motion),
             ours = nlohmann::json::parse(moved.our_motion);
  EXPECT_EQ(theirs["times"].size(), moved.moments.size());
  EXPECT_EQ(theirs["strands"], ours["strands"]) << "so that a page compares their points";
  EXPECT_LE(moved.our_motion.size(), 500'000U) << "a class has thousands";
  EXPECT_EQ(moved.film.size(), kFilmShots);

  played.dense[3][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(compare_runs(hidden.scene, hidden.pictures, played).finite);
}

TEST(RunComparison, SeesWhatAWorkerMayAnswer) {
  const HiddenScene hidden = hidden_scene_of("H1");
  const Played right = play(hidden.scene);
  const auto compared = [&](const Played& theirs) {
    return compare_runs(hidden.scene, hidden.pictures, theirs);
  };

  Played none = right;
  none.frames.clear();
  EXPECT_TRUE(compared(none).moments.empty());
  EXPECT_TRUE(compared(none).shots.empty());

  Played short_one = right;
  short_one.frames.resize(static_cast<std::size_t>(hidden.pictures[1]) + 1);
  EXPECT_EQ(compared(short_one).shots.size(), 2U);
  EXPECT_TRUE(compared(short_one).shots[1].breaks_off);
  short_one.frames.pop_back();
  const std::vector<Shot> shots = compared(short_one).shots;
  ASSERT_EQ(shots.size(), 2U) << "its last frame, in the place of one that it does not have";
  EXPECT_FALSE(shots[0].breaks_off);
  EXPECT_TRUE(shots[1].breaks_off);
  EXPECT_NE(shots[1].name, compared(right).shots[1].name);
  EXPECT_FALSE(compared(right).shots[2].breaks_off);

  Played not_finite = right;
  not_finite.frames[5].v[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(compared(not_finite).finite);
  EXPECT_EQ(compared(not_finite).moments.size(), 5U);

  Played far_away = right;  // 1e300 m: its energy is no number, and no picture can show it
  far_away.frames[static_cast<std::size_t>(hidden.pictures[1])].x[4] = 1e300;
  ASSERT_EQ(compared(far_away).shots.size(), 2U) << "the frame before";
  EXPECT_TRUE(compared(far_away).shots[1].breaks_off);

  Played creeping = right;  // its root creeps by a billionth of a metre a frame
  for (std::size_t i = 0; i < creeping.frames.size(); ++i)
    creeping.frames[i].x[0] += 1e-9 * static_cast<double>(i);
  const RunComparison crept = compared(creeping);
  EXPECT_GT(crept.moments.back().held_apart, kHeld * crept.size);
}

}  // namespace
}  // namespace grader::judge
