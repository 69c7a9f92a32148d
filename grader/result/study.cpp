// STAFF ONLY. Names the ends of a study's runs.
#include "grader/result/study.h"

#include <algorithm>

namespace grader::inline result {

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

double step_of(const PartStudy& part, int steps) {
  return part.duration / steps;
}

}  // namespace grader::result
