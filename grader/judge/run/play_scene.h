// STAFF ONLY. Plays a scene with the exercises that this is linked with.
#pragma once

#include "grader/judge/run/play.h"

namespace grader::inline judge {

// Until it ends or breaks. What was played stays in `played` if an exercise throws.
void play_scene(const hair::Scene& scene, Played& played);

}  // namespace grader::judge
