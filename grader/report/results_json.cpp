// STAFF ONLY.
#include "grader/report/results_json.h"

#include <nlohmann/json.hpp>

#include "grader/report/student_view.h"
#include "grader/report/text.h"
#include "hair/io/plot/readable.h"

namespace grader {
namespace {

using Json = nlohmann::ordered_json;

std::string joined(const std::string& first, const std::string& second) {
  return first.empty() || second.empty() ? first + second : first + "\n\n" + second;
}

Json test(const ExerciseResult& exercise, const std::string& number, const std::string& name, Status status,
          double points, double max_points, const std::string& output) {
  return {{"name", hair::readable(name)},
          {"number", number},
          {"score", rounded_points(points)},
          {"max_score", rounded_points(max_points)},
          {"status", status == Status::passed ? "passed" : "failed"},
          {"output", hair::readable(output)},
          {"output_format", "text"},
          {"tags", Json::array({exercise.id})},
          {"visibility", "visible"},
          {"extra_data", {{"exercise", exercise.id}, {"status", to_string(status)}}}};
}

// Gradescope shows it; it changes no score.
Json run_test(const RunResult& run, const std::string& number) {
  return {{"name", "End to end: " + hair::readable(run.shows)},
          {"number", number},
          {"score", 0},
          {"max_score", 0},
          {"status", run.outcome == RunOutcome::same ? "passed" : "failed"},
          {"output", hair::readable(to_string(run.outcome) + ": " + run.feedback)},
          {"output_format", "text"},
          {"tags", Json::array({"runs"})},
          {"visibility", "visible"},
          {"extra_data", {{"run", hair::readable(run.name)}, {"outcome", to_string(run.outcome)}}}};
}

}  // namespace

std::string student_json(const SubmissionResult& whole) {
  const SubmissionResult result = for_student(whole);
  Json tests = Json::array();
  Json exercises = Json::object();
  for (const ExerciseResult& exercise : result.exercises) {
    if (exercise.cases.empty()) {
      tests.push_back(test(exercise, exercise.id, exercise.title, exercise.status, exercise.points,
                           exercise.max_points, joined(exercise.feedback, exercise.compiler_messages)));
    }
    for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
      const CaseResult& one = exercise.cases[i];
      tests.push_back(test(exercise, exercise.id + "." + std::to_string(i + 1), one.name, one.status,
                           one.points, one.max_points,
                           joined(one.feedback, i == 0 ? exercise.compiler_messages : "")));
    }
    exercises[exercise.id] = {{"status", to_string(exercise.status)},
                              {"score", rounded_points(exercise.points)},
                              {"max_score", rounded_points(exercise.max_points)},
                              {"extra_credit", exercise.extra_credit},
                              {"output", hair::readable(exercise.feedback)}};
  }
  for (std::size_t i = 0; i < result.runs.size(); ++i)
    tests.push_back(run_test(result.runs[i], "runs." + std::to_string(i + 1)));
  const std::string said = said_of(result.isolation);
  const std::string stamp =
      joined(said.empty() ? "" : said + ".", result.images ? "" : "Graded without pictures.");
  const Json all = {
      {"score", rounded_points(points(result))},
      {"output", joined(stamp, hair::readable(result.note))},
      {"output_format", "text"},
      {"visibility", "visible"},
      {"stdout_visibility", "hidden"},
      {"tests", tests},
      {"extra_data",
       {{"exercises", exercises}, {"isolation", to_string(result.isolation)}, {"images", result.images}}}};
  return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace grader
