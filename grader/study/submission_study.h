// STAFF ONLY. The study of a submission: all of its end-to-end scenes, one after the other.
#pragma once

#include <filesystem>
#include <optional>

#include "grader/report/study_result.h"
#include "grader/study/study.h"
#include "grader/suite/end_to_end.h"

namespace grader {

// What a worker's CPU time is limited to. Each part may take most_seconds, and the play that begins before they are over:
// with twice the steps of the one before, it takes about as long as all before it together.
int study_cpu_seconds(const StudySettings& settings = {});

// Both workers have the server of scenes and objects of all exercises, the reference's those of the reference. Scenes
// that can't be run say why, and are not played. What is true of a part is kept in `kept`, for the class. Throws
// std::runtime_error if the reference fails.
SubmissionStudy study_submission(Student& student, Student& reference, const AvailableExercises& exercises,
                                 const std::optional<std::filesystem::path>& kept,
                                 const StudySettings& settings = {});

}  // namespace grader
