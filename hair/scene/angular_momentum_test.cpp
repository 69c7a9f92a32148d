// STAFF ONLY. The effect of methods on angular momentum and energy: the numbers of H4's and H6's texts, from
// scenes.
//
// H4's text also has 0.6583 for converged backward Euler, which no program computes. On a circle a step turns
// by b after a step by a, with tan b = sin a / (2 - cos a), from tan b = h Omega at the start, and the part
// sin b / (h Omega) of the momentum remains.
#include <gtest/gtest.h>

#include "hair/scene/scene.h"
#include "hair/scene/scene_run.h"

namespace reference_tests {
namespace {

using hair::GeometricTerm, hair::Method, hair::SceneRun, hair::Scene;

double left_after_a_revolution(Method method, std::optional<GeometricTerm> term = {}) {
  Scene scene = hair::read_scene(HAIR_SCENES "/angular-momentum.json");
  scene.hair.method = method;
  scene.hair.geometric_term = term;
  SceneRun scene_run(scene);
  const double before = scene_run.measure(scene_run.state()).angular_momentum[1];
  for (int frame = 0; frame < scene.frames; ++frame) scene_run.advance();
  return scene_run.measure(scene_run.state()).angular_momentum[1] / before;
}

TEST(AngularMomentum, IsLeftAfterARevolution) {
  // Rounding in lengths, 2^-53 of 0.3 m, is 1e-9 of the stretch that turns the mass.
  EXPECT_NEAR(left_after_a_revolution(Method::implicit_euler, GeometricTerm::full), 0.0049185, 5e-8);
  EXPECT_NEAR(left_after_a_revolution(Method::implicit_euler, GeometricTerm::filtered), 0.0049185, 5e-8);
  EXPECT_NEAR(left_after_a_revolution(Method::implicit_euler, GeometricTerm::dropped), 1, 1e-6);
  EXPECT_NEAR(left_after_a_revolution(Method::predictor_corrector), 0.77662, 5e-6);
}

// The part of its energy that a hair of 10 segments loses in `seconds`, swinging by 0.1 rad.
double lost(double stretch_factor, std::optional<GeometricTerm> term, int seconds) {
  const auto scene_of = [&](const std::string& direction) {
    Scene scene = hair::parse_scene(
        R"({"shows": "x", "frames": 1, "hair": [{"segments": 10, "length": 0.1, "clamped": false,
      "material": {"stretch_factor": )" +
            std::to_string(stretch_factor) + R"(}, "roots": {"list": [{"position": [0, 0, 0]}]},
      "start": {"direction": )" +
            direction + "}}]}",
        "swing");
    scene.frames = 30 * seconds;
    scene.hair.geometric_term = term;
    return scene;
  };
  SceneRun hanging(scene_of("[0, 0, -1]")), swinging(scene_of("[0.0998334166, 0, -0.9950041653]"));
  const double rest = hanging.measure(hanging.state()).energy(),
               before = swinging.measure(swinging.state()).energy() - rest;
  for (int frame = 0; frame < 30 * seconds; ++frame) swinging.advance();
  return 1 - (swinging.measure(swinging.state()).energy() - rest) / before;
}

// H6's lengths are exact, so its springs have no geometric term. A filtered term would have the positive
// mean of its rounding errors, a drag that grows with the springs' stiffness.
TEST(AngularMomentum, AndEnergyAreNotLostToRoundingByH6) {
  const double soft = lost(1e4, {}, 5), stiff = lost(1e7, {}, 5);
  EXPECT_NEAR(stiff, soft, 0.01 * soft) << "what a step takes does not depend on the stiffness";
  EXPECT_GT(lost(1e7, GeometricTerm::filtered, 5), 3 * soft) << "nothing is shown";
}

}  // namespace
}  // namespace reference_tests
