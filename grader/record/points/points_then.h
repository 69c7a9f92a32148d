// STAFF ONLY. The points of a grading, small enough to keep for each one: the log has them, and they suffice
// for a comparison with an earlier grading.
#pragma once

#include <string>
#include <vector>

#include "grader/result/fields.h"
#include "grader/result/result.h"

namespace grader::inline record {

struct PointsThen {
  std::string place, title;  // "H2.3", "Ill-conditioned systems"; "H2" for an exercise without categories
  double points = 0, max_points = 0;
};

}  // namespace grader::record

namespace grader {

template <>
struct Fields<PointsThen> {
  static const Rows<PointsThen>& rows();
};

}  // namespace grader

namespace grader::inline record {

// Counts the categories of each exercise from 1.
std::vector<PointsThen> points_then(const SubmissionResult& result);
// Reads them from the detail of the log's entry; errors name it `name`.
std::vector<PointsThen> points_then(const std::string& detail, const std::string& name);

}  // namespace grader::record
