// STAFF ONLY. The suite runs a scene, and a student's worker answers for its exercise alone. See
// grader/judge/run/play.h.
#pragma once

#include <filesystem>

#include "grader/judge/cases/trial.h"
#include "grader/judge/run/play.h"

namespace grader::inline judge {

// Returns the function of a runner, which stays loaded: a suite runs one exercise. Throws std::runtime_error
// if the file has no such function.
PlayFunction load_runner(const std::filesystem::path& runner);

// `runner` is the library for the exercise of the trial's student. Throws CaseFailed, or MalformedMessage if
// an answer has another format.
Played play_with_student(Trial& trial, const std::filesystem::path& runner, const hair::Scene& scene);

}  // namespace grader::judge
