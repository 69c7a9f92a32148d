// STAFF ONLY. The scenes of a study and their parts, with the reference.
#include "grader/judge/study/scenes.h"

#include <gtest/gtest.h>

#include <set>

#include "hair/scene/scene_run.h"

namespace grader::inline judge {
namespace {

TEST(StudiedScenes, EachEndsSoundAndTogetherTheyNeedAllExercisesThatScenesCall) {
  std::set<std::string> all;
  for (const SceneText& text : studied_scenes()) {
    const hair::Scene scene = hair::parse_scene(text.json, text.name);
    for (const std::string& id : exercises_of(scene)) all.insert(id);
    hair::SceneRun scene_run(scene);
    const particles::State start = scene_run.state();
    while (scene_run.frame() < scene.frames) ASSERT_FALSE(scene_run.advance()) << text.name;
    EXPECT_TRUE(scene_run.state().x.allFinite() && scene_run.state().v.allFinite()) << text.name;
    // Something must move by at least a tenth of a millimetre.
    EXPECT_GT((scene_run.state().x - start.x).norm(), 1e-4) << text.name;
  }
  EXPECT_EQ(all, (std::set<std::string>{"S1", "P1", "P2", "H1", "H2", "H3", "H4", "H5", "H6"}));
}

TEST(Parts, PlayTheSameMotionInOtherSteps) {
  for (const SceneText& text : studied_scenes())
    for (const StudiedPart& part : parts_of(text)) {
      const std::vector<TimeGrid> all = grids_of(part.scene);
      EXPECT_GE(all.size(), 6U) << part.name;
      bool own = false;
      for (std::size_t i = 0; i < all.size(); ++i) {
        const SceneText other = on_grid(part, all[i]);
        const hair::Scene scene = hair::parse_scene(other.json, other.name);
        EXPECT_NEAR(scene.frames / scene.frames_per_second, part.scene.frames / part.scene.frames_per_second,
                    1e-15);
        EXPECT_EQ(scene.frames * scene.steps_per_frame, all[i].steps());
        EXPECT_EQ(part.scene.frames % scene.frames, 0) << part.name;
        EXPECT_TRUE(i == 0 || all[i].steps() == 2 * all[i - 1].steps()) << part.name;
        own = own || all[i].steps() == part.scene.frames * part.scene.steps_per_frame;
      }
      EXPECT_TRUE(own) << part.name;
    }
}

}  // namespace
}  // namespace grader::judge
