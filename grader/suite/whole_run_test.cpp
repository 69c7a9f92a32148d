// STAFF ONLY. Hidden scenes are what they say, and a run that is not what it should be is seen to be so.
#include "grader/suite/whole_run.h"
#include "grader/suite/suite_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>

#include "grader/course/course.h"
#include "grader/course/input.h"
#include "hair/scene/playback.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

const fs::path kScenes = HAIR_HIDDEN_SCENES;

HiddenScene hidden_scene_of(const std::string& exercise, const std::string& seed = "a seed") {
  return read_hidden_scene(kScenes / (exercise + ".json"), seed);
}

Played play(const hair::Scene& scene) {
  hair::Playback playback(scene);
  Played played{{playback.state()}, ""};
  for (int frame = 0; frame < scene.frames; ++frame) {
    played.trouble = playback.advance().value_or("");
    played.frames.push_back(playback.state());
  }
  return played;
}

TEST(HiddenScene, EachExerciseWithPointsForItsRunHasOneThatCallsIt) {
  for (const Exercise& exercise : read_course(fs::path(HAIR_PROJECT) / "handout/exercises.json").exercises) {
    SCOPED_TRACE(exercise.id);
    ASSERT_EQ(whole_run_points(exercise.id).run > 0, fs::exists(kScenes / (exercise.id + ".json")));
    if (whole_run_points(exercise.id).run == 0) continue;
    const HiddenScene hidden = hidden_scene_of(exercise.id);
    const std::vector<std::string> called = hair::exercises_of(hidden.scene);
    EXPECT_NE(std::find(called.begin(), called.end(), exercise.id), called.end());
    EXPECT_EQ(hidden.pictures.size(), 3U);
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
  try {
    read_hidden_scene(file, "");
    ADD_FAILURE() << "accepted";
  } catch (const BadInput& error) {
    EXPECT_NE(std::string(error.what()).find("expected a JSON pointer to one"), std::string::npos)
        << error.what();
  }
  fs::remove(file);
}

TEST(RunComparison, OfTheReferenceItselfNeedsNoPicturesOfItsOwn) {
  const HiddenScene hidden = hidden_scene_of("H1");
  const RunComparison run = compare_runs(hidden.scene, hidden.pictures, play(hidden.scene));
  EXPECT_TRUE(run.finite);
  ASSERT_EQ(run.shots.size(), 3U);
  for (const Shot& shot : run.shots) EXPECT_TRUE(shot.same);
  for (const Moment& moment : run.moments) EXPECT_EQ(moment.apart, 0);
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

  Played not_finite = right;
  not_finite.frames[5].v[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(compared(not_finite).finite);
  EXPECT_EQ(compared(not_finite).moments.size(), 5U);

  Played far_away = right;  // 1e300 m: its energy is no number, and no picture has room for it
  far_away.frames[static_cast<std::size_t>(hidden.pictures[1])].x[4] = 1e300;
  EXPECT_EQ(compared(far_away).shots.size(), 1U);

  Played creeping = right;  // the root, by a billionth of a metre a frame
  for (std::size_t i = 0; i < creeping.frames.size(); ++i)
    creeping.frames[i].x[0] += 1e-9 * static_cast<double>(i);
  const RunComparison crept = compared(creeping);
  EXPECT_GT(crept.moments.back().held_apart, kHeld * crept.size);
}

}  // namespace
}  // namespace grader
