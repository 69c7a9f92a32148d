// STAFF ONLY. Runs a scene with the exercises that are linked here.
#pragma once

#include "grader/judge/run/play.h"

namespace grader::inline judge {

// Runs until the scene ends or breaks. Frames stay in `played` if an exercise throws.
void play_scene(const hair::Scene& scene, Played& played);

}  // namespace grader::judge
