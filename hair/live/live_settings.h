// A scene that somebody changes while it runs: other steps, another stiffness, another method.
#pragma once

#include <string>
#include <vector>

#include "hair/course/course.h"
#include "hair/scene/scene.h"

namespace hair {

inline constexpr double kMostTimesStep = 32, kMostTimesStiffness = 1000, kMostWind = 20;

struct LiveSettings {
  double step = 1;       // times the scene's step: 1 / kMostTimesStep to kMostTimesStep
  double stiffness = 1;  // times the scene's stiffness: 1 / kMostTimesStiffness to kMostTimesStiffness
  double wind = 0;       // m/s along x, beyond the scene's: 0 to kMostWind
  std::string method;    // a method's id; empty: the scene's
};

// "2 0.5 3 implicit_euler"; "1 1 0" leaves the scene as it is. Throws BadInput for other texts, and for numbers
// out of bounds.
LiveSettings read_settings(const std::string& text);

// The methods that can move the contents of the scene, and whose exercises are in the course.
std::vector<const MethodRow*> methods_for(const Scene& scene, const Course& course);

// The scene's method; null if its toys have several.
const MethodRow* method_of(const Scene& scene);

// Afterwards each frame of the scene is one step, and the roots of all strands ride on a motion. Throws
// BadInput for a method that is not one of `methods_for`.
void change(Scene& scene, const LiveSettings& settings, const Course& course);

}  // namespace hair
