// STAFF ONLY. Lists the changes of a later grading: by place, from the points in the log.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/record/record.h"

namespace grader::inline record {

struct PointsChange {
  std::string place, title;             // "H2.3"
  std::optional<double> before, after;  // nothing: the place did not exist
};

// Compares the last grading and the one before it; with `since`, the last one up to that time, "2025-03-04
// 10:15:22". Returns nothing if there are no two gradings.
std::vector<PointsChange> changes(const std::vector<LogEntry>& log, const std::string& since = "");

}  // namespace grader::record
