// STAFF ONLY. What a worker's server of scenes answers: see grader/worker/serve_runs.cpp.
#pragma once

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
};

// Has the student's worker play a scene: it gets the text, of which we made `scene`. Throws CaseFailed, or
// MalformedMessage if the answer has another form.
Played play_elsewhere(Trial& trial, const std::string& text, const hair::Scene& scene);

}  // namespace grader
