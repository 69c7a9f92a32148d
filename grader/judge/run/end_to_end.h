// STAFF ONLY. End to end: all files of a submission together run small scenes, compared with the reference.
// The results are shown, but not scored.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "grader/judge/student/student.h"
#include "grader/result/result.h"
#include "hair/scene/scene.h"

namespace grader {

struct AvailableExercises {
  std::set<std::string> left_out;                  // by the course; also leaves out scenes that need one
  std::map<std::string, std::string> unavailable;  // exercise -> reason: "does not compile"
};

// Whether the course leaves out a scene; and the reason why it can't be run: "H4 does not compile.", or
// empty.
bool is_left_out(const hair::Scene& scene, const AvailableExercises& exercises);
std::string why_not_run(const hair::Scene& scene, const AvailableExercises& exercises);

// A result for each scene of the course, in the order of end_to_end_scenes.h. Scenes that can't be run don't
// start a worker. The reference's pictures are stored in `kept_pictures`; without it no pictures are drawn.
std::vector<RunResult> run_end_to_end(Student& student, const AvailableExercises& exercises,
                                      const std::optional<std::filesystem::path>& kept_pictures);

}  // namespace grader
