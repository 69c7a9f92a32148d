// STAFF ONLY. All given code, linked with the replacements of exercises that are not in a course: here of all
// exercises.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "hair/course/course.h"
#include "hair/scene/scene_run.h"
#include "solver/normal_equations.h"
#include "solver/not_in_course.h"

namespace hair {
namespace {

TEST(NotInCourse, IsWhatAScenesFirstStepSays) {
  std::set<std::string> said;
  for (const auto& entry : std::filesystem::directory_iterator(HAIR_SCENES)) {
    if (entry.path().extension() != ".json") continue;
    const Scene scene = read_scene(entry.path());
    const std::vector<std::string> called = exercises_of(scene);
    try {
      SceneRun scene_run(scene);
      scene_run.advance();
      ADD_FAILURE() << scene.name << " moves";
    } catch (const NotInCourse& error) {
      const std::string what = error.what(), id = what.substr(0, what.find(' '));
      EXPECT_EQ(std::count(called.begin(), called.end(), id), 1) << scene.name << ": " << what;
      EXPECT_TRUE(what.ends_with(" is not in this course")) << what;
      said.insert(id);
    }
  }
  EXPECT_GT(said.size(), 3U);
}

TEST(NotInCourse, NamesTheExerciseAndTheFunction) {
  try {
    solve_normal_equations(0, 0, nullptr, nullptr, nullptr, nullptr, 0, nullptr);
    ADD_FAILURE();
  } catch (const NotInCourse& error) {
    EXPECT_STREQ(error.what(), "S2 solve_normal_equations is not in this course");
  }
}

}  // namespace
}  // namespace hair
