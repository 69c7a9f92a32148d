// STAFF ONLY. A whole run: the suite plays a scene, and asks a student's worker for its exercise alone. See
// grader/judge/run/play.h.
#pragma once

#include <filesystem>

#include "grader/judge/run/play.h"
#include "grader/judge/trial.h"

namespace grader::inline judge {

// The function of a player. It stays loaded: a suite plays one exercise. Throws std::runtime_error without
// one.
PlayFunction load_player(const std::filesystem::path& player);

// `player` is the object that plays with the exercise of the trial's student. Throws CaseFailed, or
// MalformedMessage if an answer has another form.
Played play_with_student(Trial& trial, const std::filesystem::path& player, const hair::Scene& scene);

}  // namespace grader::judge
