// Courses of few exercises, read by one program: the scenes that it runs, and its messages for the others.
#include "hair/lab/run/course_scene.h"

#include <gtest/gtest.h>

#include "hair/io/files/bad_input.h"
#include "hair/lab/tests/run_hairlab.h"

namespace hair {
namespace {

// A course file with these exercises alone.
std::string file_of(const std::vector<std::string>& ids) {
  std::string roles;
  for (const Exercise& exercise : read_course(HAIR_EXERCISES_JSON).exercises)
    if (std::find(ids.begin(), ids.end(), exercise.id) == ids.end())
      roles += (roles.empty() ? "\"" : ", \"") + exercise.id + "\": {\"role\": \"absent\"}";
  return "{\"exercises\": {" + roles + "}}";
}

struct Some {
  std::vector<std::string> ids;
  std::vector<std::string> plays;  // some of the shipped scenes, in alphabetical order
};

const Some kCourses[] = {
    {{"S1"}, {}},
    {{"P1"}, {"pendulum"}},
    {{"S1", "P1", "P2"}, {"bead-on-wire", "pendulum", "rod-pendulum"}},
    {{"S1", "H1", "H2"}, {}},
    {{"S1", "H1", "H4"}, {"cloth-patch", "head-of-hair", "wavy"}},
    {{"H7"}, {"rigid-links"}},
    {{"H8"}, {"super-helix"}},
};

TEST(CourseScene, IsReadIfTheCourseHasAllThatItCalls) {
  const TestFolder folder;
  for (const Some& some : kCourses) {
    const std::string text = file_of(some.ids);
    const Course course = read_course(HAIR_EXERCISES_JSON, folder.write("course.json", text));
    std::vector<std::string> plays;
    for (const std::string& name : shipped_scenes(HAIR_SCENES_DIR)) {
      try {
        EXPECT_EQ(read_course_scene(name, course).name, name);
        plays.push_back(name);
      } catch (const BadInput& error) {
        const std::string what = error.what();
        EXPECT_TRUE(has(what, name + ".json: needs exercise ") && has(what, "which this course leaves out"))
            << what;
      }
    }
    EXPECT_EQ(plays, some.plays) << text;
  }
}

TEST(CourseScene, WithAllExercisesEachShippedSceneIsRead) {
  const Course course = read_course(HAIR_EXERCISES_JSON);
  for (const std::string& name : shipped_scenes(HAIR_SCENES_DIR))
    EXPECT_NO_THROW(read_course_scene(name, course)) << name;
}

TEST(CourseScene, IsAskedOfTheCourseFileThatHairlabIsGiven) {
  const TestFolder folder;
  const std::string course = folder.write("course.json", file_of({"S1", "P1"}));
  const ProgramRun run = run_hairlab({"run", "wavy", "--explain", "--course", course});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(has(run.errors, "wavy.json: needs exercise H1, which this course leaves out")) << run.errors;
  EXPECT_EQ(lines_of(run.errors), 1);
  const ProgramRun played = run_hairlab({"run", "pendulum", "--explain", "--course", course});
  EXPECT_EQ(played.code, 0) << played.errors;
  EXPECT_TRUE(has(played.output, "exercise P1") && !has(played.output, "exercise P2")) << played.output;
  const ProgramRun bad =
      run_hairlab({"scenes", "--course", folder.write("bad.json", "{\"exercises\": {\"none\": {}}}")});
  EXPECT_EQ(bad.code, 2);
  EXPECT_TRUE(has(bad.errors, "bad.json: exercises.none: there is no such exercise")) << bad.errors;
  EXPECT_EQ(lines_of(bad.errors), 1);
}

}  // namespace
}  // namespace hair
