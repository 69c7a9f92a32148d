// STAFF ONLY. What a later grading changed: by place, from the points in the log.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/record/record.h"

namespace grader::inline record {

struct PointsChange {
  std::string place, title;             // "H2.3"
  std::optional<double> before, after;  // nothing: the place was not there
};

// Between the last grading and the one before it; with `since`, the last one up to then, "2025-03-04
// 10:15:22". Nothing if there are no two gradings.
std::vector<PointsChange> changes(const std::vector<LogEntry>& log, const std::string& since = "");

}  // namespace grader::record
