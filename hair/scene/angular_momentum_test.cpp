// STAFF ONLY. Angular momentum and energy that methods lose. The public checks of H4 and H6 ask their own
// rows of the texts' table.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hair/scene/scene.h"
#include "hair/scene/scene_run.h"

namespace reference_tests {
namespace {

using hair::GeometricTerm, hair::SceneRun, hair::Scene;

// H4's text has this row for converged backward Euler, which no program here computes. On a circle a step
// turns by b after a step by a, with tan b = sin a / (2 - cos a), from tan b = h Omega at the start, and the
// part sin b / (h Omega) of the momentum remains.
TEST(AngularMomentum, BackwardEulerLosesAThirdInARevolution) {
  const double first = 2 * std::numbers::pi / 60;
  double turned = std::atan(first);
  for (int step = 1; step < 60; ++step) turned = std::atan2(std::sin(turned), 2 - std::cos(turned));
  EXPECT_NEAR(std::sin(turned) / first, 0.6583, 5e-5);
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
