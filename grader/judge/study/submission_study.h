// STAFF ONLY. The study of a submission: all scenes, one after the other.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "grader/judge/study/study.h"
#include "grader/result/study.h"

namespace grader::inline judge {

struct AvailableExercises {
  std::set<std::string> left_out;                  // left out by the course, as scenes that need one are
  std::map<std::string, std::string> unavailable;  // exercise -> reason: "does not compile"
};

// Limits a worker's CPU time. Each part may take most_seconds, plus the run that starts before they end: with
// twice the steps of the previous run, it takes about as long as all runs before it together.
int study_cpu_seconds(const StudySettings& settings = {});

// Both workers have the server of scenes and the objects of all exercises; the reference's worker has the
// reference's objects. Scenes that can't run have a reason in the result. The true motion of each part is
// stored in `kept`, for the class. Throws std::runtime_error if the reference fails.
SubmissionStudy study_submission(Student& student, Student& reference, const AvailableExercises& exercises,
                                 const std::optional<std::filesystem::path>& kept,
                                 const StudySettings& settings = {});

}  // namespace grader::judge
