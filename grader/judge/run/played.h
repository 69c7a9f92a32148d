// STAFF ONLY. Runs of a scene in which a worker answers: for one exercise (grader/judge/run/play.h), or by
// itself, with all of a submission's objects (grader/worker/serve_runs.cpp).
#pragma once

#include <filesystem>
#include <string>

#include "grader/judge/cases/trial.h"
#include "grader/judge/run/play.h"

namespace grader::inline judge {

// Returns the function of a runner, which stays loaded: a suite runs one exercise. Throws std::runtime_error
// if the file has no such function.
PlayFunction load_runner(const std::filesystem::path& runner);

// `runner` is the library for the exercise of the trial's student. Throws CaseFailed, or MalformedMessage if
// an answer has another format.
Played play_with_student(Trial& trial, const std::filesystem::path& runner, const hair::Scene& scene);

// Lets the student's worker run a scene `times` times: it gets the text of `scene`. Throws CaseFailed, or
// MalformedMessage if the answer has another format.
Played play_elsewhere(Trial& trial, const std::string& text, const hair::Scene& scene, int times = 1);

}  // namespace grader::judge
