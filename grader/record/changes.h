// STAFF ONLY. Lists the changes of a later grading: by place, from the points in the log.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/record/points/points_then.h"
#include "grader/record/record.h"

namespace grader::inline record {

struct PointsChange {
  std::string place, title;             // "H2.3", as it is called now
  std::optional<double> before, after;  // nothing: the place did not exist
};

// Compares categories by title, for in another suite a number may be another's.
std::vector<PointsChange> changes(const std::vector<PointsThen>& before,
                                  const std::vector<PointsThen>& after);

// Compares the last grading and the one before it. Returns nothing if there are no two gradings.
std::vector<PointsChange> changes(const std::vector<LogEntry>& log);

}  // namespace grader::record
