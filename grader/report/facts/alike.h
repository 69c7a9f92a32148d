// STAFF ONLY. People who fail alike: they lose the same categories of an exercise by errors of the same size.
#pragma once

#include <string>
#include <vector>

#include "grader/result/result.h"

namespace grader::inline report {

// This is the size of an error in bands that a hidden input or another compiler hardly changes; near: below
// 10 times.
enum class ErrorSize { unknown, near, up_to_a_thousand, up_to_a_million, more, not_finite };
ErrorSize size_of(const CaseResult& one);
std::string in_words(ErrorSize size);  // "10 to 1000 times the limit"; "" for unknown

struct LostCategory {
  std::string number;  // "H2.3"
  const CaseResult* one = nullptr;
};
std::vector<LostCategory> lost_categories(const ExerciseResult& exercise);

// They may share a misunderstanding, or a source; or the limit is wrong.
struct FailAlike {
  std::string exercise;
  std::vector<std::string> categories, people;
  std::vector<ErrorSize> sizes;  // has one for each category
};

// Lists three people and more, who lose two categories or more, or one by an error of known size; most people
// first.
std::vector<FailAlike> who_fail_alike(const std::vector<const SubmissionResult*>& results);
std::vector<FailAlike> who_fail_alike(const std::vector<SubmissionResult>& results);

}  // namespace grader::report
