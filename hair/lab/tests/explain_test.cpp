// --explain describes each part, and agrees with the calls of a scene.
#include "hair/lab/run/explain.h"

#include <gtest/gtest.h>

#include <map>

#include "hair/lab/run/run_record.h"
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
  EXPECT_NE(text.find("strand 1234 (the first of 9012) "), std::string::npos) << text;
  EXPECT_NE(text.find(", from step 5678 on: 3.45 "), std::string::npos) << text;
}

TEST(Explain, LeavesOutOfALimpHairAllButStretchingGravityAndWhatSolves) {
  const auto parts = parts_of(R"({"shows": "x", "frames": 1, "hair": [{"segments": 3, "length": 0.1,
    "material": {"bend_factor": 0}, )" +
                              kRoots + "}]}");
  EXPECT_EQ(names(parts, true), "gravity, hair, method, preconditioner, stretching");
  EXPECT_EQ(parts.at("bending").why, "no strand resists it: EI is 0");
  EXPECT_EQ(parts.at("OpenGL").why, "the scene has no \"render\": no library is loaded");
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
  EXPECT_EQ(parts.at("still hair").why, "5 strands that go with a head, and only are drawn");
  EXPECT_EQ(parts.at("bending").why, "H2, angular springs at the joints of 1 strand");
  EXPECT_EQ(parts.at("rest curvature").why, "given, at the joints of 1 strand");
  EXPECT_EQ(parts.at("dense hair").why, "H10, 7 strands of 1 guide, less those out of view");
  EXPECT_EQ(
      parts.at("strand clearance").why,
      "up to 7 strands out of 1 obstacle; of each picture's strands only those that touch one are moved");
}

TEST(Explain, SaysWhyPartsThatAreAskedForAreLeftOut) {
  const std::string scene = R"({"shows": "x", "frames": 1, "wind": [1, 0, 0], "gravity": [0, 0, 0],
    "hair": [{"segments": 9, "length": 0.1, "shape": {"curly": {"radius": 0.01, "pitch": 0.02}}, )" +
                            kRoots + R"(}], "render": {"shadows": false}})";
  auto parts = parts_of(scene);
  EXPECT_EQ(parts["wind"].why, "without drag it moves nothing");
  EXPECT_EQ(parts["bending"].why, "rest curvature takes its place");
  EXPECT_EQ(parts["shadows"].why, "\"shadows\" is false");
  EXPECT_FALSE(parts["gravity"].used);
  parts = parts_of(scene, false);
  for (const char* name : {"pictures", "shadows", "film"}) EXPECT_EQ(parts[name].why, "--no-render") << name;
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

}  // namespace
}  // namespace hair
