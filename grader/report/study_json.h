// STAFF ONLY. A study as JSON: study.json, and how the suite hands it over. README.md has its form.
#pragma once

#include <string>

#include "grader/report/study_result.h"

namespace grader {

std::string study_json(const SubmissionStudy& study);

// Throws std::runtime_error for a text that is no study.
SubmissionStudy study_from_json(const std::string& text);

}  // namespace grader
