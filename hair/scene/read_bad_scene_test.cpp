// STAFF ONLY. Mistakes in a scene, each with the one line that reports it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <regex>

#include "hair/io/files/bad_input.h"
#include "hair/scene/test_reading.h"
#include "solver/test_refusal.h"

namespace reference_tests {
namespace {

// A scene with another value at a path such as hair[0].clamped, or without one there.
std::string with_value(const std::string& scene, const std::string& path, const std::string& value) {
  auto json = nlohmann::ordered_json::parse(scene);
  const nlohmann::ordered_json::json_pointer at(
      "/" + std::regex_replace(std::regex_replace(path, std::regex("[.\\[]"), "/"), std::regex("\\]"), ""));
  if (value.empty())
    json.at(at.parent_pointer()).erase(at.back());
  else
    json[at] = nlohmann::ordered_json::parse(value);
  return json.dump();
}

// `where` stands in the message: the path of the value, unless it is given.
void expect_said_of(const std::string& scene, const std::string& path, const std::string& value,
                    const std::string& said, const std::optional<std::string>& where = {}) {
  const std::string place = where.value_or(path);
  EXPECT_EQ(complaint(with_value(scene, path, value)),
            "a.json: " + place + (place.empty() ? "" : ": ") + said)
      << path << " = " << value;
}

void expect_said(const std::string& path, const std::string& value, const std::string& said,
                 const std::optional<std::string>& where = {}) {
  expect_said_of(small_scene(), path, value, said, where);
}

TEST(BadScene, AWrongKeyIsNamedWithItsPath) {
  expect_said("hair[0].material", R"({"skipfactor": 0})",
              "unknown key \"skipfactor\"; known here: radius, density, young_modulus, stretch_factor, "
              "bend_factor, twist_factor, skip_factor, relaxation_time, joint_limit");
  expect_said("frames", "",
              "\"frames\" is missing; an object here has: shows, frames, frames_per_second, "
              "steps_per_frame, step, gravity, wind, method, drag, geometric_term, bend_product, tolerance, "
              "preconditioner, hair, links, obstacles, motions, toys, still_hair, render",
              "");
  expect_said("hair[1].shape", R"({"curled": {}})", "unknown key \"curled\"; known here: wavy, curly");
  expect_said("hair[1].shape", "{}", "has 0 keys; give one of: wavy, curly");
  expect_said("hair[2].roots", R"({"groom": {}})",
              "unknown key \"groom\"; known here: list, line, disc, cap");
  expect_said("obstacles[0]", R"({"friction": 0.5})", "give one of: plane, sphere, capsule, bust");
}

TEST(BadScene, AWrongTypeIsNamedWithItsPath) {
  expect_said("frames", R"("two")", "\"two\" is not right; give a whole number from 1 to 100000");
  expect_said("frames", "2.5", "2.5 is not right; give a whole number from 1 to 100000");
  expect_said("shows", "3", "3 is not text; write \"...\"");
  expect_said("hair[0].clamped", "1", "1 is not right; write true or false");
  expect_said("gravity", "-9.81", "-9.81 is not a list of three numbers, [x, y, z]");
  expect_said("gravity", "[0, -9.81]", "[0,-9.81] is not a list of three numbers, [x, y, z]");
  expect_said("gravity[2]", "null", "null is not right; give a number from -1000000 to 1000000");
  expect_said("geometric_term", R"("none")", "\"none\" is not right; write one of: full, filtered, dropped");
  expect_said("toys[0].springs", "{}", "{} is not a list; write [...]");
  expect_said("wind[2]", "1e300", "1e+300 is not right; give a number from -1000000 to 1000000");
}

TEST(BadScene, AWrongValueIsNamedWithItsPath) {
  expect_said("toys[0].particles[1].mass", "-2", "-2 is not right; give a number from 1e-15 to 1000000");
  expect_said("hair[0].segments", "0", "0 is not right; give a whole number from 1 to 10000");
  expect_said("step", "0", "0 is not right; give a number from 1e-09 to 10");
  expect_said("step", "-0.001", "-0.001 is not right; give a number from 1e-09 to 10");
  expect_said("step", "0.001", "\"steps_per_frame\" says it already; keep one of the two");
  const std::string in_steps = with_value(small_scene(), "steps_per_frame", "");
  for (const auto& [step, steps] : {std::pair{"0.01", "3.3333333333333335"}, {"1", "0.03333333333333333"}})
    expect_said_of(in_steps, "step", step,
                   "makes " + std::string(steps) +
                       " steps a frame; give one that makes a whole number, from 1 to 1000000");
  expect_said("tolerance", "0", "0 is not right; give a number from 1e-15 to 1");
  expect_said("frames", "0", "0 is not right; give a whole number from 1 to 100000");
  expect_said("hair[2].roots.line.count", "1000000000",
              "1000000000 is not right; give a whole number from 1 to 10000000");
  expect_said("hair[2].roots.line.count", "9000000",
              "makes 18000023 particles in all; a scene has at most 10000000");
  expect_said_of(with_value(small_scene(), "toys[1].cloth.rows", "10000"), "toys[1].cloth.columns", "10000",
                 "makes 100000036 particles in all; a scene has at most 10000000", "toys[1].cloth");
  expect_said("hair[0].shape.wavy.wavelength", "0.02",
              "the length of a segment over that of a wave or turn is 1.2666403937930706; it must be at most "
              "1/4",
              "hair[0]");
  expect_said("hair[0].roots.list[0].direction", "[0, 0, 0]",
              "has no direction; give one that is not [0, 0, 0]");
  expect_said("hair[0].roots.list", "[]", "has no roots; give one at least");
  expect_said("toys[1].cloth.across", "[0, 0, 1]", "lies along \"across\"; a cloth has an area",
              "toys[1].cloth.down");
  expect_said("obstacles[1].sphere.radius", "0", "0 is not right; give a number from 1e-07 to 10000");
  expect_said("toys[0].rods[0].length", "0", "0 is not right; give a number from 1e-07 to 10000");
}

TEST(BadScene, PartsThatDoNotFitAreNamedWithTheirPath) {
  expect_said("motions[0].keys[1].time", "0.1",
              "is not later than the key before it; give times that increase");
  expect_said("motions[0].keys[1].degrees", "9e9",
              "9000000000.0 is not right; give a number from -3600 to 3600");
  expect_said("motions[0].keys[1].degrees", "270",
              "is more than 180 degrees from the key before it; put keys between them");
  expect_said("motions[0].keys[1].degrees", "", "\"axis\" and \"degrees\" go together; give both or none",
              "motions[0].keys[1]");
  expect_said("motions[1]", R"({"name": "hat", "keys": [{"time": 0}]})",
              "nothing moves with \"hat\"; write it as \"moves_with\", or leave it out", "motions");
  expect_said("motions[1]", R"({"name": "head", "keys": [{"time": 0}]})",
              "is the name of a motion before it; give another", "motions[1].name");
  expect_said("hair[0].moves_with", R"("hat")", "no motion has this name; look at \"motions\"");
  expect_said("obstacles[0].moves_with", R"("head")",
              "this motion turns, and only a sphere or a bust can move with it");
  expect_said("hair[1].moves_with", R"("head")",
              "these roots move with a motion already; keep one of the two", "hair[1].root_velocity");
  expect_said("still_hair", R"([{"groom": {"style": "wavy", "strands": 9, "points": 8}}])",
              "is too few to follow the style; give 53 at least", "still_hair[0].groom.points");
  expect_said("hair[0].clamped", "false",
              "wavy and curly hair must be clamped; write true, or leave the shape out");
  expect_said("toys[0].rods[0].between[1]", "3", "3 is not right; give a whole number from 0 to 2");
  expect_said("toys[0].rods[0].between", "[1, 1]", "is twice the same particle; give two");
  expect_said("toys[0].rods[0].between", "[1]", "does not have two particles; write [0, 1]");
  expect_said("toys[0].particles[2].position", "[1, 0, 0]",
              "are two particles at one place, and a rod needs a direction; move one of them",
              "toys[0].rods[0].between");
  expect_said("toys[0].method", R"("implicit_euler")", "rods and wires need an explicit method");
}

TEST(BadScene, ATextThatIsNoJsonIsNamedWithItsLine) {
  const auto said = [](const std::string& what, const std::string& by) {
    return complaint(small_scene(what, by));
  };
  const std::string frames = R"("frames": 2,)", literal =
                                                    "a.json: line 3, column 13: not JSON: syntax error "
                                                    "while parsing value - invalid literal; last read: ";
  EXPECT_EQ(said(frames, R"("frames": NaN,)"), literal + "'\"frames\": N'");
  EXPECT_EQ(said(frames, R"("frames": Infinity,)"), literal + "'\"frames\": I'");
  EXPECT_EQ(said(R"("drag": 1e-4)", R"("drag": 1e999)"),
            "a.json: line 9, column 15: not JSON: number overflow parsing '1e999'");
  EXPECT_EQ(
      said(frames, R"("frames": 2)"),
      "a.json: line 4, column 21: not JSON: syntax error while parsing object - unexpected string literal; "
      "expected '}'");
  EXPECT_EQ(said(frames, R"("frames": 2, "frames": 3,)"),
            "a.json: \"frames\" stands twice in the same object; keep one of them");
}

TEST(BadScene, HairThatCantBeLinkedSaysWhy) {
  EXPECT_EQ(complaint(linked_scene()), "");
  expect_said_of(linked_scene(), "hair[0].clamped", "false",
                 "links are for clamped hair, whose roots have frames; leave out \"clamped\": false",
                 "links");
  expect_said_of(linked_scene(), "method", R"("predictor_corrector")",
                 "linked hair moves by implicit Euler; write \"method\": \"implicit_euler\"", "links");
  expect_said_of(with_value(linked_scene(), "hair[0].model", R"("super_helix")"), "hair[1].model",
                 R"("super_helix")",
                 "links are for hair of masses and springs; leave them out, or the \"model\"", "links");
  expect_said_of(linked_scene(), "links.breaks", "0.5",
                 "a link can't break before it yields; give \"yields\" or more");
  expect_said_of(linked_scene(), "hair",
                 R"([{"segments": 2, "length": 0.1, "roots": {"list": [{"position": [0, 0, 0]}]}}])",
                 "no hair has a neighbour; give a group with two roots or more", "links");
}

TEST(BadScene, DenseHairNeedsRootsWithRoomBetweenThem) {
  const auto said = [](const std::string& roots, const std::string& more = "") {
    const std::string message = complaint(R"({"shows": "x", "frames": 1, "render": {}, "hair": [
          {"segments": 2, "length": 0.1, "roots": {"list": [{"position": [0, 0, 0]}]}},
          {"segments": 1, "length": 0.1, "roots": {"list": [)" +
                                          roots + R"(]}, "synthesis": {"strands": 9)" + more + "}}]}");
    return message.substr(message.find("hair"));
  };
  const std::string two = R"({"position": [0, 0, 0]}, {"position": [1, 0, 0]})";
  EXPECT_EQ(said(two),
            "hair[1].synthesis: the roots are on a line, and have no room for more between them; give three "
            "at least that are not");
  const std::string three = two + R"(, {"position": [0, 1, 0]})";
  EXPECT_EQ(
      complaint(
          R"({"shows": "x", "frames": 1, "render": {}, "hair": [{"segments": 1, "length": 0.1, "roots": {"list": [)" +
          three + R"(]}, "synthesis": {"strands": 9}}]})"),
      "");
  EXPECT_EQ(
      said(three, R"(, "rows": 2)"),
      "hair[1].synthesis.rows: hair[0] has strands of 3 points, and this group of 2; give them as many");
  EXPECT_EQ(said(three, R"(, "rows": 3)"),
            "hair[1].synthesis.rows: is more than the groups that are there; there are 2");
}

TEST(BadScene, OneThatHasNothingToMoveSaysSo) {
  EXPECT_EQ(complaint(R"({"shows": "nothing", "frames": 1})"),
            "a.json: there is nothing that moves; give \"hair\" or \"toys\"");
  EXPECT_EQ(complaint(R"({"shows": "nothing", "frames": 1, "hair": [], "toys": []})"),
            "a.json: there is nothing that moves; give \"hair\" or \"toys\"");
  const std::string toy = R"("toys": [{"particles": [{"position": [0, 0, 0], "mass": 1}]}])";
  EXPECT_EQ(complaint(R"({"shows": "a ball", "frames": 1, )" + toy + "}"), "");
  EXPECT_EQ(complaint(R"({"shows": "a ball", "frames": 1, "method": "midpoint", )" + toy + "}"),
            "a.json: method: is for hair, and there is none; leave it out");
  EXPECT_EQ(complaint(R"({"shows": "a ball", "frames": 1, "toys": [{"particles": []}]})"),
            "a.json: toys[0].particles: has no particles; give one at least");
}

TEST(BadScene, AllFramesTogetherHaveABound) {
  const std::string scene = R"({"shows": "much", "frames": 100000, "hair": [{"segments": 100, "length": 1,
    "roots": {"line": {"from": [0, 0, 0], "to": [1, 0, 0], "count": 1000}}}]})";
  EXPECT_EQ(
      complaint(scene),
      "a.json: hair[0].roots.line.count: makes 101000 particles in 100000 frames; particles times frames are "
      "at most 1000000000");
}

TEST(BadScene, WhatIsNestedWithoutEndIsRefused) {
  EXPECT_EQ(complaint(std::string(100000, '[')),
            "a.json: more than 64 lists and objects within each other; nothing here needs as many");
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_EQ(complaint(objects),
            "a.json: more than 64 lists and objects within each other; nothing here needs as many");
}

TEST(BadScene, ATextOfASceneNamesNoFiles) {
  EXPECT_EQ(
      complaint(
          R"({"shows": "a groom", "frames": 1, "hair": [{"groom": {"file": "/etc/passwd", "scale": 1}}]})"),
      "a.json: hair[0].groom.file: this scene can't have files of its own; leave the groom out");
}

TEST(BadScene, AFileThatCantBeReadIsNamed) {
  const auto said = [](const std::filesystem::path& file) -> std::string {
    return tests::refusal<hair::BadInput>([&] { hair::read_scene(file); });
  };
  EXPECT_EQ(said("no-such.json"),
            "no-such.json: can't be read (No such file or directory); give the path of a JSON file");
  EXPECT_EQ(said("/"), "/: can't be read (Is a directory); give the path of a JSON file");
}

}  // namespace
}  // namespace reference_tests
