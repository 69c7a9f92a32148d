// STAFF ONLY. The answer of a worker's server of scenes: see grader/worker/serve_runs.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grader/suite/trial.h"
#include "hair/scene/scene.h"
#include "particles/state.h"

namespace grader {

// A scene that a worker played. Its sizes are checked; its numbers are untrusted and may be anything.
struct Played {
  std::vector<particles::State> frames;  // the first is the start; at most as many as the scene has
  std::string trouble;                   // empty, or the place of a blow-up

  // Counts, as the worker reports them.
  std::int64_t solver_steps = 0;      // of ConjGrad
  std::int64_t correction_steps = 0;  // of the length correction
};

// Lets the student's worker play a scene `times` times: it gets the text, from which we made `scene`. Throws
// CaseFailed, or MalformedMessage if the answer has another form.
Played play_elsewhere(Trial& trial, const std::string& text, const hair::Scene& scene, int times = 1);

}  // namespace grader
