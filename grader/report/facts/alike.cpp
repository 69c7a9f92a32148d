// STAFF ONLY. Compares people by the size of their errors.
#include "grader/report/facts/alike.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace grader::inline report {
namespace {

constexpr std::size_t kFewestAlike = 3, kFewestLost = 2;

}  // namespace

ErrorSize size_of(const CaseResult& one) {
  const double times = one.error_in_limits;
  if (times == 0) return ErrorSize::unknown;
  if (times == kNoNumber) return ErrorSize::not_finite;
  return times < 10    ? ErrorSize::near
         : times < 1e3 ? ErrorSize::up_to_a_thousand
         : times < 1e6 ? ErrorSize::up_to_a_million
                       : ErrorSize::more;
}

std::string in_words(ErrorSize size) {
  switch (size) {
    case ErrorSize::unknown:
      return "";
    case ErrorSize::near:
      return "up to 10 times the limit";
    case ErrorSize::up_to_a_thousand:
      return "10 to 1000 times the limit";
    case ErrorSize::up_to_a_million:
      return "1000 to a million times the limit";
    case ErrorSize::more:
      return "more than a million times the limit";
    case ErrorSize::not_finite:
      return "not a finite number";
  }
  return "";
}

std::vector<LostCategory> lost_categories(const ExerciseResult& exercise) {
  std::vector<LostCategory> lost;
  for (std::size_t i = 0; i < exercise.cases.size(); ++i)
    if (const CaseResult& one = exercise.cases[i]; one.status != Status::passed)
      lost.push_back({exercise.id + "." + std::to_string(i + 1), &one});
  return lost;
}

std::vector<FailAlike> who_fail_alike(const std::vector<const SubmissionResult*>& results) {
  using Lost = std::vector<std::string>;
  std::map<std::tuple<std::string, Lost, std::vector<ErrorSize>>, std::vector<std::string>> found;
  for (const SubmissionResult* result : results)
    for (const ExerciseResult& exercise : result->exercises) {
      Lost lost;
      std::vector<ErrorSize> sizes;
      for (const LostCategory& one : lost_categories(exercise)) {
        lost.push_back(one.number);
        sizes.push_back(size_of(*one.one));
      }
      // A person who loses all categories shows no single misunderstanding.
      const bool says_something = lost.size() >= kFewestLost || sizes != std::vector{ErrorSize::unknown};
      if (exercise.status != Status::excused && !lost.empty() && lost.size() < exercise.cases.size() &&
          says_something)
        found[{exercise.id, std::move(lost), std::move(sizes)}].push_back(result->name);
    }
  std::vector<FailAlike> groups;
  for (auto& [key, people] : found)
    if (people.size() >= kFewestAlike)
      groups.push_back({std::get<0>(key), std::get<1>(key), std::move(people), std::get<2>(key)});
  std::ranges::stable_sort(groups, std::ranges::greater{},
                           [](const FailAlike& group) { return group.people.size(); });
  return groups;
}

std::vector<FailAlike> who_fail_alike(const std::vector<SubmissionResult>& results) {
  std::vector<const SubmissionResult*> all;
  for (const SubmissionResult& result : results) all.push_back(&result);
  return who_fail_alike(all);
}

}  // namespace grader::report
