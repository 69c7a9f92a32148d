// STAFF ONLY.
#include "grader/report/results_json.h"

#include <nlohmann/json.hpp>

#include "grader/course/input.h"
#include "grader/report/picture_files.h"
#include "grader/report/student_view.h"
#include "grader/report/text.h"
#include "hair/io/plot/readable.h"

namespace grader {
namespace {

using Json = nlohmann::ordered_json;

std::string dumped(const Json& json) {
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

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

Json case_json(const CaseResult& one) {
  return {{"name", hair::valid_utf8(one.name)},
          {"status", to_string(one.status)},
          {"points", one.points},
          {"max_points", one.max_points},
          {"feedback", hair::valid_utf8(one.feedback)},
          {"detail", hair::valid_utf8(one.detail)},
          {"memory_error", hair::valid_utf8(one.memory_error)},
          {"cases", one.cases},
          {"held", one.held}};
}

CaseResult case_from(const Json& json) {
  return {json.at("name"),         status_from_string(json.at("status")),
          json.at("points"),       json.at("max_points"),
          json.at("feedback"),     json.at("detail"),
          json.at("memory_error"), json.at("cases"),
          json.at("held")};
}

Json pictures_json(const std::vector<PictureResult>& pictures) {
  Json all = Json::array();
  for (const PictureResult& picture : pictures)
    all.push_back({{"name", hair::valid_utf8(picture.name)},
                   {"blurred_rmse", picture.blurred_rmse},
                   {"flip", picture.flip},
                   {"student", picture_name(picture.student)},
                   {"reference", picture_name(picture.reference)},
                   {"heat", picture_name(picture.heat)},
                   {"blurred_rmse_limit", picture.blurred_rmse_limit},
                   {"flip_limit", picture.flip_limit},
                   {"far_off", picture.far_off}});
  return all;
}

std::vector<PictureResult> pictures_from(const Json& json, const std::filesystem::path& folder) {
  std::vector<PictureResult> pictures;
  const auto bytes = [&](const Json& name) { return read_picture(folder, name); };
  for (const Json& one : json)
    pictures.push_back({one.at("name"), one.at("blurred_rmse"), one.at("flip"), bytes(one.at("student")),
                        bytes(one.at("reference")), bytes(one.at("heat")), one.at("blurred_rmse_limit"),
                        one.at("flip_limit"), one.at("far_off")});
  return pictures;
}

Json exercise_json(const ExerciseResult& exercise) {
  Json cases = Json::array();
  for (const CaseResult& one : exercise.cases) cases.push_back(case_json(one));
  return {{"id", hair::valid_utf8(exercise.id)},
          {"title", hair::valid_utf8(exercise.title)},
          {"file", hair::valid_utf8(exercise.file)},
          {"extra_credit", exercise.extra_credit},
          {"status", to_string(exercise.status)},
          {"points", exercise.points},
          {"max_points", exercise.max_points},
          {"feedback", hair::valid_utf8(exercise.feedback)},
          {"compiler_messages", hair::valid_utf8(exercise.compiler_messages)},
          {"cases", cases},
          {"pictures", pictures_json(exercise.pictures)},
          {"staff_log", hair::valid_utf8(exercise.staff_log)},
          {"allocations", exercise.allocations}};
}

ExerciseResult exercise_from(const Json& json, const std::filesystem::path& pictures) {
  ExerciseResult exercise;
  exercise.id = json.at("id");
  exercise.title = json.at("title");
  exercise.file = json.at("file");
  exercise.extra_credit = json.at("extra_credit");
  exercise.status = status_from_string(json.at("status"));
  exercise.points = json.at("points");
  exercise.max_points = json.at("max_points");
  exercise.feedback = json.at("feedback");
  exercise.compiler_messages = json.at("compiler_messages");
  for (const Json& one : json.at("cases")) exercise.cases.push_back(case_from(one));
  exercise.pictures = pictures_from(json.at("pictures"), pictures);
  exercise.staff_log = json.at("staff_log");
  exercise.allocations = json.at("allocations");
  return exercise;
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

Json run_json(const RunResult& run) {
  return {{"name", hair::valid_utf8(run.name)},     {"shows", hair::valid_utf8(run.shows)},
          {"outcome", to_string(run.outcome)},      {"feedback", hair::valid_utf8(run.feedback)},
          {"detail", hair::valid_utf8(run.detail)}, {"pictures", pictures_json(run.pictures)}};
}

RunResult run_from(const Json& json, const std::filesystem::path& pictures) {
  return {json.at("name"),     json.at("shows"),  run_outcome_from_string(json.at("outcome")),
          json.at("feedback"), json.at("detail"), pictures_from(json.at("pictures"), pictures)};
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
                           one.points, one.max_points, one.feedback));
    }
    exercises[exercise.id] = {{"status", to_string(exercise.status)},
                              {"score", rounded_points(exercise.points)},
                              {"max_score", rounded_points(exercise.max_points)},
                              {"extra_credit", exercise.extra_credit},
                              {"output", hair::readable(exercise.feedback)}};
  }
  for (std::size_t i = 0; i < result.runs.size(); ++i)
    tests.push_back(run_test(result.runs[i], "runs." + std::to_string(i + 1)));
  const std::string stamp = joined(result.isolated ? "" : "Graded without a sandbox.",
                                   result.images ? "" : "Graded without pictures.");
  return dumped(
      {{"score", rounded_points(points(result))},
       {"output", joined(stamp, hair::readable(result.note))},
       {"output_format", "text"},
       {"visibility", "visible"},
       {"stdout_visibility", "hidden"},
       {"tests", tests},
       {"extra_data", {{"exercises", exercises}, {"isolated", result.isolated}, {"images", result.images}}}});
}

std::string staff_json(const SubmissionResult& result) {
  Json exercises = Json::array();
  for (const ExerciseResult& exercise : result.exercises) exercises.push_back(exercise_json(exercise));
  Json runs = Json::array();
  for (const RunResult& run : result.runs) runs.push_back(run_json(run));
  Json all = {{"name", hair::valid_utf8(result.name)},
              {"fingerprint", hair::valid_utf8(result.fingerprint)},
              {"isolated", result.isolated},
              {"images", result.images},
              {"note", hair::valid_utf8(result.note)},
              {"exercises", exercises},
              {"runs", runs}};
  if (result.studied) all["studied"] = true;
  return dumped(all);
}

std::optional<SubmissionResult> result_from_staff_json(const std::string& text,
                                                       const std::filesystem::path& pictures) {
  try {
    const Json json = Json::parse(text);
    SubmissionResult result;
    result.name = json.at("name");
    result.fingerprint = json.at("fingerprint");
    result.isolated = json.at("isolated");
    result.images = json.at("images");
    result.note = json.at("note");
    result.studied = json.value("studied", false);
    for (const Json& exercise : json.at("exercises"))
      result.exercises.push_back(exercise_from(exercise, pictures));
    for (const Json& run : json.at("runs")) result.runs.push_back(run_from(run, pictures));
    return result;
  } catch (const Json::exception&) {
    return {};
  } catch (const std::invalid_argument&) {  // an unknown status or outcome
    return {};
  } catch (const BadInput&) {  // a picture
    return {};
  }
}

}  // namespace grader
