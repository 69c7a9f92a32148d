// STAFF ONLY. What a worker's server of scenes answers: see grader/worker/serve_runs.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grader/suite/trial.h"
#include "hair/scene/scene.h"
#include "particles/state.h"

namespace grader {

// A scene that was played elsewhere. Nothing in it is believed but its sizes: numbers may be anything.
struct Played {
  std::vector<particles::State> frames;  // the first is the start; at most those of the scene
  std::string trouble;                   // empty, or where it broke

  // What it says that it took.
  std::int64_t solver_steps = 0;      // of ConjGrad
  std::int64_t correction_steps = 0;  // of the length correction
};

// Has the student's worker play a scene, `times` times: it gets the text, of which we made `scene`. Throws CaseFailed,
// or MalformedMessage if the answer has another form.
Played play_elsewhere(Trial& trial, const std::string& text, const hair::Scene& scene, int times = 1);

}  // namespace grader
