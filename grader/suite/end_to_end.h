// STAFF ONLY. End to end: all of a submission's files together run small scenes beside the reference. What
// comes out is shown and not scored.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "grader/report/result.h"
#include "grader/suite/student.h"
#include "hair/scene/scene.h"

namespace grader {

struct AvailableExercises {
  std::set<std::string> left_out;                  // by the course: scenes that call one are no part of it
  std::map<std::string, std::string> unavailable;  // why a submission's can't be called: "does not compile"
};

// Whether a scene is no part of the course; and why it can't be run: "H4 does not compile.", or nothing.
bool is_left_out(const hair::Scene& scene, const AvailableExercises& exercises);
std::string why_not_run(const hair::Scene& scene, const AvailableExercises& exercises);

// A result for each scene of the course, in the order of end_to_end_scenes.h. Scenes that can't be run don't
// start a worker. The reference's pictures are kept in `kept_pictures`; without it none are drawn.
std::vector<RunResult> run_end_to_end(Student& student, const AvailableExercises& exercises,
                                      const std::optional<std::filesystem::path>& kept_pictures);

}  // namespace grader
