// STAFF ONLY. Mistakes in a scene, each with the one line that reports it.
#include <gtest/gtest.h>

#include <ostream>

#include "hair/io/files/bad_input.h"
#include "hair/scene/test_reading.h"
#include "solver/test_refusal.h"

namespace reference_tests {
namespace {

struct Slip {
  const char *what, *by, *said;
};

void PrintTo(const Slip& slip, std::ostream* out) {
  *out << slip.by;
}

class BadScene : public testing::TestWithParam<Slip> {};

TEST_P(BadScene, IsNamedWithItsPath) {
  const Slip& slip = GetParam();
  EXPECT_EQ(complaint(small_scene(slip.what, slip.by)), std::string("a.json: ") + slip.said);
}

INSTANTIATE_TEST_SUITE_P(
    Keys, BadScene,
    testing::Values(
        Slip{R"("skip_factor": 0)", R"("skipfactor": 0)",
             "hair[0].material: unknown key \"skipfactor\"; known here: radius, density, young_modulus, "
             "stretch_factor, bend_factor, twist_factor, skip_factor, relaxation_time, joint_limit"},
        Slip{R"("frames": 2,)", "",
             "\"frames\" is missing; an object here has: shows, frames, frames_per_second, "
             "steps_per_frame, step, gravity, wind, method, drag, geometric_term, "
             "bend_product, tolerance, preconditioner, hair, links, obstacles, motions, toys, still_hair, "
             "render"},
        Slip{R"("curly":)", R"("curled":)", "hair[1].shape: unknown key \"curled\"; known here: wavy, curly"},
        Slip{R"("curly": {"radius": 0.005, "pitch": 0.1})", "",
             "hair[1].shape: has 0 keys; give one of: wavy, curly"},
        Slip{R"("line": {)", R"("groom": {)",
             "hair[2].roots: unknown key \"groom\"; known here: list, line, disc, cap"},
        Slip{R"("frames": 2,)", R"("frames": 2, "frames": 3,)",
             "\"frames\" stands twice in the same object; keep one of them"},
        Slip{R"({"plane": {"point": [0, 0, -1], "normal": [0, 0, 1]}, "friction": 0.5})",
             R"({"friction": 0.5})", "obstacles[0]: give one of: plane, sphere, capsule, bust"}));

INSTANTIATE_TEST_SUITE_P(
    Types, BadScene,
    testing::Values(
        Slip{R"("frames": 2,)", R"("frames": "two",)",
             "frames: \"two\" is not right; give a whole number from 1 to 100000"},
        Slip{R"("frames": 2,)", R"("frames": 2.5,)",
             "frames: 2.5 is not right; give a whole number from 1 to 100000"},
        Slip{R"("shows": "all kinds of things")", R"("shows": 3)", "shows: 3 is not text; write \"...\""},
        Slip{R"("clamped": true)", R"("clamped": 1)", "hair[0].clamped: 1 is not right; write true or false"},
        Slip{R"("gravity": [0, 0, -9.81])", R"("gravity": -9.81)",
             "gravity: -9.81 is not a list of three numbers, [x, y, z]"},
        Slip{R"("gravity": [0, 0, -9.81])", R"("gravity": [0, -9.81])",
             "gravity: [0,-9.81] is not a list of three numbers, [x, y, z]"},
        Slip{R"("gravity": [0, 0, -9.81])", R"("gravity": [0, 0, null])",
             "gravity[2]: null is not right; give a number from -1000000 to 1000000"},
        Slip{R"("geometric_term": "filtered")", R"("geometric_term": "none")",
             "geometric_term: \"none\" is not right; write one of: full, filtered, dropped"},
        Slip{R"("springs": [{"between": [0, 1], "stiffness": 10, "rest_length": 1, "damping": 0.1}])",
             R"("springs": {})", "toys[0].springs: {} is not a list; write [...]"},
        Slip{R"("wind": [0, 1, 0])", R"("wind": [0, 1e5, 1e300])",
             "wind[2]: 1e+300 is not right; give a number from -1000000 to 1000000"}));

INSTANTIATE_TEST_SUITE_P(
    Values, BadScene,
    testing::Values(
        Slip{R"("mass": 2,)", R"("mass": -2,)",
             "toys[0].particles[1].mass: -2 is not right; give a number from 1e-15 to 1000000"},
        Slip{R"("segments": 4,)", R"("segments": 0,)",
             "hair[0].segments: 0 is not right; give a whole number from 1 to 10000"},
        Slip{R"("steps_per_frame": 8)", R"("step": 0)",
             "step: 0 is not right; give a number from 1e-09 to 10"},
        Slip{R"("tolerance": 1e-10)", R"("tolerance": 0)",
             "tolerance: 0 is not right; give a number from 1e-15 to 1"},
        Slip{R"("steps_per_frame": 8)", R"("step": -0.001)",
             "step: -0.001 is not right; give a number from 1e-09 to 10"},
        Slip{R"("steps_per_frame": 8)", R"("step": 0.01)",
             "step: makes 3.3333333333333335 steps a frame; give one that makes a whole number, from 1 to "
             "1000000"},
        Slip{R"("steps_per_frame": 8)", R"("step": 1)",
             "step: makes 0.03333333333333333 steps a frame; give one that makes a whole number, from 1 to "
             "1000000"},
        Slip{R"("steps_per_frame": 8)", R"("steps_per_frame": 8, "step": 0.001)",
             "step: \"steps_per_frame\" says it already; keep one of the two"},
        Slip{R"("frames": 2,)", R"("frames": 0,)",
             "frames: 0 is not right; give a whole number from 1 to 100000"},
        Slip{R"("count": 3)", R"("count": 1000000000)",
             "hair[2].roots.line.count: 1000000000 is not right; give a whole number from 1 to 10000000"},
        Slip{R"("count": 3)", R"("count": 9000000)",
             "hair[2].roots.line.count: makes 18000023 particles in all; a scene has at most 10000000"},
        Slip{R"("rows": 3, "columns": 4)", R"("rows": 10000, "columns": 10000)",
             "toys[1].cloth: makes 100000036 particles in all; a scene has at most 10000000"},
        Slip{R"("amplitude": 0.001, "wavelength": 0.2)", R"("amplitude": 0.001, "wavelength": 0.02)",
             "hair[0]: the length of a segment over that of a wave or turn is 1.2666403937930706; it must be "
             "at most 1/4"},
        Slip{R"("direction": [1, 0, 0]}]})", R"("direction": [0, 0, 0]}]})",
             "hair[0].roots.list[0].direction: has no direction; give one that is not [0, 0, 0]"},
        Slip{R"([{"position": [0, 0, 0], "direction": [1, 0, 0]}])", "[]",
             "hair[0].roots.list: has no roots; give one at least"},
        Slip{R"("across": [3, 0, 0])", R"("across": [0, 0, 1])",
             "toys[1].cloth.down: lies along \"across\"; a cloth has an area"},
        Slip{R"("radius": 0.1}, "moves_with")", R"("radius": 0}, "moves_with")",
             "obstacles[1].sphere.radius: 0 is not right; give a number from 1e-07 to 10000"}));

INSTANTIATE_TEST_SUITE_P(
    Parts, BadScene,
    testing::Values(
        Slip{R"({"time": 1, "position")", R"({"time": 0.1, "position")",
             "motions[0].keys[1].time: is not later than the key before it; give times that increase"},
        Slip{R"("degrees": 90)", R"("degrees": 9e9)",
             "motions[0].keys[1].degrees: 9000000000.0 is not right; give a number from -3600 to 3600"},
        Slip{R"("degrees": 90)", R"("degrees": 270)",
             "motions[0].keys[1].degrees: is more than 180 degrees from the key before it; put keys between "
             "them"},
        Slip{R"(, "degrees": 90)", "",
             "motions[0].keys[1]: \"axis\" and \"degrees\" go together; give both or none"},
        Slip{R"("moves_with": "head")", R"("moves_with": "hat")",
             "hair[0].moves_with: no motion has this name; look at \"motions\""},
        Slip{R"({"name": "head")", R"({"name": "hat", "keys": [{"time": 0}]}, {"name": "head")",
             "motions: nothing moves with \"hat\"; write it as \"moves_with\", or leave it out"},
        Slip{R"("hair": [)",
             R"("still_hair": [{"groom": {"style": "wavy", "strands": 9, "points": 8}}], "hair": [)",
             "still_hair[0].groom.points: is too few to follow the style; give 53 at least"},
        Slip{R"({"name": "head")", R"({"name": "head", "keys": [{"time": 0}]}, {"name": "head")",
             "motions[1].name: is the name of a motion before it; give another"},
        Slip{R"("friction": 0.5)", R"("friction": 0.5, "moves_with": "head")",
             "obstacles[0].moves_with: this motion turns, and only a sphere or a bust can move with it"},
        Slip{R"("root_velocity": [0, 0, 1])", R"("root_velocity": [0, 0, 1], "moves_with": "head")",
             "hair[1].root_velocity: these roots move with a motion already; keep one of the two"},
        Slip{R"("clamped": true)", R"("clamped": false)",
             "hair[0].clamped: wavy and curly hair must be clamped; write true, or leave the shape out"},
        Slip{R"("between": [1, 2])", R"("between": [1, 3])",
             "toys[0].rods[0].between[1]: 3 is not right; give a whole number from 0 to 2"},
        Slip{R"("between": [1, 2])", R"("between": [1, 1])",
             "toys[0].rods[0].between: is twice the same particle; give two"},
        Slip{R"("between": [1, 2])", R"("between": [1])",
             "toys[0].rods[0].between: does not have two particles; write [0, 1]"},
        Slip{R"("length": 1})", R"("length": 0})",
             "toys[0].rods[0].length: 0 is not right; give a number from 1e-07 to 10000"},
        Slip{R"("position": [2, 0, 0], "mass")", R"("position": [1, 0, 0], "mass")",
             "toys[0].rods[0].between: are two particles at one place, and a rod needs a direction; move one "
             "of "
             "them"},
        Slip{R"("method": "runge_kutta_4")", R"("method": "implicit_euler")",
             "toys[0].method: rods and wires need an explicit method"}));

INSTANTIATE_TEST_SUITE_P(
    Syntax, BadScene,
    testing::Values(
        Slip{R"("frames": 2,)", R"("frames": NaN,)",
             "line 3, column 13: not JSON: syntax error while parsing value - invalid literal; last read: "
             "'\"frames\": N'"},
        Slip{R"("frames": 2,)", R"("frames": Infinity,)",
             "line 3, column 13: not JSON: syntax error while parsing value - invalid literal; last read: "
             "'\"frames\": I'"},
        Slip{R"("drag": 1e-4)", R"("drag": 1e999)",
             "line 9, column 15: not JSON: number overflow parsing '1e999'"},
        Slip{R"("frames": 2,)", R"("frames": 2)",
             "line 4, column 21: not JSON: syntax error while parsing object - unexpected string literal; "
             "expected "
             "'}'"}));

TEST(BadScene, HairThatCantBeLinkedSaysWhy) {
  EXPECT_EQ(complaint(linked_scene()), "");
  EXPECT_EQ(
      complaint(linked_scene("\"clamped\": true", "\"clamped\": false")),
      "a.json: links: links are for clamped hair, whose roots have frames; leave out \"clamped\": false");
  EXPECT_EQ(complaint(linked_scene("\"method\": \"implicit_euler\"", "\"method\": \"predictor_corrector\"")),
            "a.json: links: linked hair moves by implicit Euler; write \"method\": \"implicit_euler\"");
  std::string links = linked_scene("\"clamped\": true", "\"model\": \"super_helix\"");
  links.replace(
      links.find("{\"segments\": 3, \"length\": 0.1,\n     \"roots\": {\"line\": {\"from\": [0, 0.01"), 1,
      "{\"model\": \"super_helix\", ");
  EXPECT_EQ(complaint(links),
            "a.json: links: links are for hair of masses and springs; leave them out, or the \"model\"");
  EXPECT_EQ(complaint(linked_scene("\"breaks\": 2", "\"breaks\": 0.5")),
            "a.json: links.breaks: a link can't break before it yields; give \"yields\" or more");
  EXPECT_EQ(complaint(R"({"shows": "a hair", "frames": 1, "method": "implicit_euler",
                          "hair": [{"segments": 2, "length": 0.1, "roots": {"list": [{"position": [0, 0, 0]}]}}],
                          "links": {"stiffness": 1}})"),
            "a.json: links: no hair has a neighbour; give a group with two roots or more");
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
