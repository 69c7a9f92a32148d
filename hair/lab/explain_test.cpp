// --explain describes each part, and agrees with the calls of a scene. A course of few exercises runs its
// scenes, and one program says what is missing for the others.

#include <gtest/gtest.h>

#include <map>

#include "hair/io/files/bad_input.h"
#include "hair/lab/run/course_scene.h"
#include "hair/lab/run/explain.h"
#include "hair/lab/run/run_record.h"
#include "hair/lab/test_run_hairlab.h"
#include "solver/test_comma_locale.h"

namespace hair {
namespace {

const Course kCourse = read_course(HAIR_EXERCISES_JSON);

std::map<std::string, Part> parts_of(const std::string& json, bool render = true) {
  std::map<std::string, Part> parts;
  const Scene scene = parse_scene(json, "scene.json");
  for (const Part& part : explain(scene, render, kCourse)) {
    EXPECT_FALSE(part.why.empty()) << part.name;
    EXPECT_TRUE(parts.emplace(part.name, part).second) << part.name << " is there twice";
  }
  for (const std::string& id : exercises_of(scene)) EXPECT_TRUE(parts["exercise " + id].used) << id;
  // A force and its exercise go together.
  EXPECT_EQ(parts["stretching"].used, parts["exercise H1"].used);
  EXPECT_EQ(parts["bending"].used, parts["exercise H2"].used);
  EXPECT_EQ(parts["springs that skip"].used, parts["exercise H3"].used);
  EXPECT_EQ(parts["constraints"].used, parts["exercise P2"].used);
  if (render) {
    EXPECT_EQ(parts["dense hair"].used, parts["exercise H10"].used);
  }
  EXPECT_EQ(parts["links"].used, parts["exercise H9"].used);
  return parts;
}

void expect_why(const std::map<std::string, Part>& parts, const std::map<std::string, std::string>& why) {
  for (const auto& [name, says] : why) EXPECT_EQ(parts.at(name).why, says) << name;
}

std::string names(const std::map<std::string, Part>& parts, bool used) {
  std::string all;
  for (const auto& [name, part] : parts)
    if (part.used == used && !name.starts_with("exercise") && name != "film")
      all += (all.empty() ? "" : ", ") + name;
  return all;
}

const std::string kRoots = R"("roots": {"list": [{"position": [0, 0, 0]}]})";

// An exercise may set C++'s locale.
TEST(Explain, AndWarningsHaveADecimalPointWhateverTheLocale) {
  const solver::CommaLocale comma(testing::TempDir());
  EXPECT_EQ(
      parts_of(
          R"({"shows": "x", "frames": 1, "gravity": [0, 0, -1234.5], "hair": [{"segments": 3, "length": 0.1, )" +
          kRoots + "}]}")
          .at("gravity")
          .why,
      "(0, 0, -1234.5) m/s^2");
  const std::string text = warning_text({{&concerns()[0], 1234, 5678, 9012, 3.45}});
  EXPECT_TRUE(says(text, "strand 1234 (the first of 9012) "));
  EXPECT_TRUE(says(text, ", from step 5678 on: 3.45 "));
}

TEST(Explain, LeavesOutOfALimpHairAllButStretchingGravityAndWhatSolves) {
  const auto parts = parts_of(R"({"shows": "x", "frames": 1, "hair": [{"segments": 3, "length": 0.1,
    "material": {"bend_factor": 0}, )" +
                              kRoots + "}]}");
  EXPECT_EQ(names(parts, true), "gravity, hair, method, preconditioner, stretching");
  expect_why(parts, {{"bending", "no strand resists it: EI is 0"},
                     {"OpenGL", "the scene has no \"render\": no library is loaded"}});
}

TEST(Explain, UsesAllPartsOfASceneThatHasThem) {
  const auto parts = parts_of(R"({"shows": "x", "frames": 1, "method": "implicit_euler", "drag": 1e-5,
    "wind": [1, 0, 0], "hair": [
      {"segments": 3, "length": 0.1, "material": {"skip_factor": 0.1}, "moves_with": "head", )" +
                              kRoots + R"(},
      {"segments": 9, "length": 0.1, "shape": {"curly": {"radius": 0.01, "pitch": 0.02}},
       "roots": {"line": {"from": [0, 0, 0], "to": [0, 0, 0], "count": 1}}, "synthesis": {"strands": 7}}],
    "links": {"stiffness": 1e-6, "neighbours": "both", "strips": {"thickness": 1e-3, "stiffness": 1e-6}},
    "obstacles": [{"sphere": {"centre": [0, 0, 0], "radius": 0.1}}],
    "motions": [{"name": "head", "keys": [{"time": 0}]}],
    "toys": [{"particles": [{"position": [0, 0, 0], "mass": 1, "pinned": true},
                            {"position": [1, 0, 0], "mass": 1}],
              "springs": [{"between": [0, 1], "stiffness": 1}], "rods": [{"between": [0, 1]}]}],
    "still_hair": [{"groom": {"style": "ponytail", "strands": 5}, "moves_with": "head"}],
    "render": {"hair": "fine"}})");
  EXPECT_EQ(names(parts, false), "");
  expect_why(
      parts,
      {{"still hair", "5 strands that go with a head, and only are drawn"},
       {"bending", "H2, angular springs at the joints of 1 strand"},
       {"rest curvature", "given, at the joints of 1 strand"},
       {"dense hair", "H10, 7 strands of 1 guide, less those out of view"},
       {"strand clearance",
        "up to 7 strands out of 1 obstacle; of each picture's strands only those that touch one are moved"}});
}

TEST(Explain, SaysWhyPartsThatAreAskedForAreLeftOut) {
  const std::string scene = R"({"shows": "x", "frames": 1, "wind": [1, 0, 0], "gravity": [0, 0, 0],
    "hair": [{"segments": 9, "length": 0.1, "shape": {"curly": {"radius": 0.01, "pitch": 0.02}}, )" +
                            kRoots + R"(}], "render": {"shadows": false}})";
  auto parts = parts_of(scene);
  expect_why(parts, {{"wind", "without drag it moves nothing"},
                     {"bending", "rest curvature takes its place"},
                     {"shadows", "\"shadows\" is false"}});
  EXPECT_FALSE(parts["gravity"].used);
  parts = parts_of(scene, false);
  expect_why(parts, {{"pictures", "--no-render"}, {"shadows", "--no-render"}, {"film", "--no-render"}});
  EXPECT_FALSE(parts["OpenGL"].used);
}

TEST(Explain, SaysWhyNoStrandIsKeptOutOfObstacles) {
  const std::string dense =
      R"("roots": {"line": {"from": [0, 0, 0], "to": [1, 0, 0], "count": 3}}, "synthesis": {"strands": 7})";
  const std::string ball = R"(, "obstacles": [{"sphere": {"centre": [0, 0, 0], "radius": 0.1}}])";
  const std::string fine = R"(, "render": {"hair": "fine"})";
  const auto why = [](const std::string& hair, const std::string& more, bool render = true) {
    const Part part = parts_of(R"({"shows": "x", "frames": 1, "hair": [{"segments": 3, "length": 0.1, )" +
                                   hair + "}]" + more + "}",
                               render)
                          .at("strand clearance");
    EXPECT_FALSE(part.used) << part.why;
    return part.why;
  };
  EXPECT_EQ(why(kRoots, ball + fine), "no dense hair is drawn");
  EXPECT_EQ(why(dense, fine), "the scene has no obstacles, so nothing is looked at");
  EXPECT_EQ(why(dense, ball + R"(, "render": {})"), "ribbons are drawn as they are made");
  EXPECT_EQ(why(dense, ball + fine, false), "--no-render");
}

TEST(Explain, SaysOfAToyThatThereIsNoHair) {
  const auto parts = parts_of(R"({"shows": "x", "frames": 1, "toys": [{"particles": [
    {"position": [0, 0, 0], "mass": 1}]}]})");
  EXPECT_EQ(names(parts, true), "gravity, toys");
  EXPECT_EQ(parts.at("stretching").why, "the scene has no hair");
}

// A course file with these exercises alone.
std::string file_of(const std::vector<std::string>& ids) {
  std::string roles;
  for (const Exercise& exercise : kCourse.exercises)
    if (std::ranges::find(ids, exercise.id) == ids.end())
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
        EXPECT_TRUE(says(what, name + ".json: needs exercise ") && says(what, "which this course leaves out"))
            << what;
      }
    }
    EXPECT_EQ(plays, some.plays) << text;
  }
  for (const std::string& name : shipped_scenes(HAIR_SCENES_DIR))
    EXPECT_NO_THROW(read_course_scene(name, kCourse)) << name;
}

TEST(CourseScene, IsAskedOfTheCourseFileThatHairlabIsGiven) {
  const TestFolder folder;
  const std::string course = folder.write("course.json", file_of({"S1", "P1"}));
  expect_refused(run_hairlab({"run", "wavy", "--explain", "--course", course}), 2,
                 "wavy.json: needs exercise H1, which this course leaves out");
  const ProgramRun played = run_hairlab({"run", "pendulum", "--explain", "--course", course});
  EXPECT_EQ(played.code, 0) << played.errors;
  EXPECT_TRUE(says(played.output, "exercise P1") && !says(played.output, "exercise P2"));
  expect_refused(
      run_hairlab({"scenes", "--course", folder.write("bad.json", "{\"exercises\": {\"none\": {}}}")}), 2,
      "bad.json: exercises.none: there is no such exercise");
}

}  // namespace
}  // namespace hair
