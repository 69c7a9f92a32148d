// STAFF ONLY.
#include "grader/report/study_result.h"

#include <algorithm>

namespace grader {

std::string to_string(StudyEnd end) {
  switch (end) {
    case StudyEnd::finished:
      return "finished";
    case StudyEnd::ran_away:
      return "ran away";
    case StudyEnd::broke:
      return "broke";
  }
  return "";
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

double step_of(const PartStudy& part, int steps) {
  return part.duration / steps;
}

}  // namespace grader
