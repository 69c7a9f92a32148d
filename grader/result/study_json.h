// STAFF ONLY. A study as JSON: study.json, also the suite's output. grader/README.md describes the format.
#pragma once

#include <string>

#include "grader/result/study.h"

namespace grader {

std::string study_json(const SubmissionStudy& study);

// Throws std::runtime_error for a text that is not a study.
SubmissionStudy study_from_json(const std::string& text);

}  // namespace grader
