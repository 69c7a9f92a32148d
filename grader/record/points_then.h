// STAFF ONLY. The points of a grading, small enough to be kept of each one: the log has them, and a
// comparison with an earlier grading needs no more.
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

// A category of each exercise, counted from 1.
std::vector<PointsThen> points_then(const SubmissionResult& result);

}  // namespace grader::record
