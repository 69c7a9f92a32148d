// STAFF ONLY. A scene that a worker runs by itself, with all of a submission's objects: the answer of
// grader/worker/serve_runs.cpp.
#pragma once

#include <string>

#include "grader/judge/cases/trial.h"
#include "grader/judge/run/play.h"

namespace grader::inline judge {

// Lets the student's worker run a scene `times` times: it gets the text of `scene`. Throws CaseFailed, or
// MalformedMessage if the answer has another format.
Played play_elsewhere(Trial& trial, const std::string& text, const hair::Scene& scene, int times = 1);

}  // namespace grader::judge
