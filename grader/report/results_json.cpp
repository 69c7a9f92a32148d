// STAFF ONLY. Writes results.json.
#include "grader/report/results_json.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "grader/compare/montage.h"
#include "grader/report/facts/student_text.h"
#include "grader/report/facts/student_view.h"
#include "grader/report/facts/text.h"
#include "hair/io/files/base64.h"
#include "hair/io/image/read_png.h"
#include "hair/io/plot/html.h"
#include "hair/io/plot/readable.h"

namespace grader::inline report {
namespace {

using hair::Html, hair::html;
using Json = nlohmann::ordered_json;

// Bounds a test's text. A byte takes at most three in ASCII (\u00e9 for two). Long texts are compilers'
// messages, one for each exercise: the course's fourteen take 0.7 MB at most.
constexpr std::size_t kMostText = 16 << 10;
constexpr const char* kOfPublicChecks =
    "These are the public checks, compiled as for grading. They give no points: the hidden ones do, after "
    "the deadline.";
constexpr int kPictureWidth = 240;  // is half the size

std::string text_of(const std::string& text) {
  const std::string shown = hair::readable(text);
  return shown.size() <= kMostText
             ? shown
             : hair::valid_utf8(shown.substr(0, kMostText)) + "\n(the rest is left out)";
}

std::string data_address(const std::string& png) {
  const hair::Image small = shrunk(hair::decode_png(png, "a picture"), kPictureWidth);
  return "data:image/png;base64," + hair::base64(hair::encode_png(small));
}

Html picture(const std::string& png, const std::string& shows) {
  if (png.empty()) return {};
  return html("<img width=\"{}\" alt=\"{}\" src=\"{}\">\n",
              {std::size_t{kPictureWidth}, shows, data_address(png)});
}

Html moments(const std::vector<PictureResult>& pictures) {
  Html all;
  for (const PictureResult& one : pictures) {
    const bool same = one.heat.empty();
    all += html(
        "<p>{}: {}</p>\n<p>{}{}{}</p>\n",
        {one.name,
         same ? "yours and the reference's are the same" : "yours, the reference's, and where they differ",
         picture(one.student, "Yours"), picture(same ? "" : one.reference, "The reference's"),
         picture(one.heat, "Where they differ")});
  }
  return all;
}

// Writes a test's output: a text, or with pictures a page's part.
void put_output(Json& test, const std::string& text, const std::vector<PictureResult>& pictures) {
  const Html shown = moments(pictures);
  test["output"] = shown.text.empty() ? text_of(text) : html("<p>{}</p>\n{}", {text_of(text), shown}).text;
  test["output_format"] = shown.text.empty() ? "text" : "html";
}

Json test(const ExerciseResult& exercise, const std::string& number, const std::string& name, Status status,
          double points, double max_points, const std::string& output,
          const std::vector<PictureResult>& pictures) {
  Json test = {
      {"name", text_of(name)},
      {"number", number},
      {"score", rounded_points(points)},
      {"max_score", rounded_points(max_points)},
      {"status",
       status == Status::passed || status == Status::excused || is_by_hand(exercise) ? "passed" : "failed"}};
  put_output(test, output, pictures);
  test.update(Json{{"tags", Json::array({exercise.id})},
                   {"visibility", "visible"},
                   {"extra_data", {{"exercise", exercise.id}, {"status", to_string(status)}}}});
  return test;
}

Json json_of(const SubmissionResult& result, const ResultsOptions& options) {
  Json tests = Json::array();
  Json exercises = Json::object();
  for (const ExerciseResult& exercise : result.exercises) {
    const std::vector<PictureResult> none, &pictures = options.pictures ? exercise.pictures : none;
    const bool whole =
        exercise.cases.empty() || exercise.status == Status::passed || exercise.status == Status::excused;
    if (whole)
      tests.push_back(test(exercise, exercise.id, exercise.title, exercise.status, exercise.points,
                           exercise.max_points,
                           joined(said_of_exercise(exercise), exercise.compiler_messages), pictures));
    for (std::size_t i = 0; i < exercise.cases.size() && !whole; ++i) {
      const CaseResult& one = exercise.cases[i];
      tests.push_back(test(exercise, exercise.id + "." + std::to_string(i + 1), one.name, one.status,
                           one.points, one.max_points,
                           joined(one.feedback, i == 0 ? exercise.compiler_messages : ""),
                           one.name == kRunTitle ? pictures : none));
    }
    exercises[exercise.id] = {{"status", to_string(exercise.status)},
                              {"score", rounded_points(exercise.points)},
                              {"max_score", rounded_points(exercise.max_points)},
                              {"extra_credit", exercise.extra_credit},
                              {"output", text_of(said_of_exercise(exercise))}};
  }
  const std::string said = said_of(result.isolation);
  const std::string stamp =
      joined(said.empty() ? "" : said + ".", result.images ? "" : "Graded without pictures.");
  const double score = rounded_points(points(result));
  Json all = {
      {"score", score},
      {"output", joined(options.public_checks ? kOfPublicChecks : stamp, text_of(said_of_the_whole(result)))},
      {"output_format", "text"},
      {"visibility", "visible"},
      {"stdout_visibility", "hidden"},
      {"tests", tests},
      {"extra_data", {{"exercises", exercises}, {"images", result.images}}}};
  if (!result.exercises.empty())
    all["extra_data"]["isolation"] = to_string(result.isolation);  // nothing ran before
  for (const Adjustment& adjustment : result.adjustments)
    all["extra_data"]["adjustments"].push_back(
        {{"reason", text_of(adjustment.reason)}, {"points", rounded_points(adjustment.points)}});
  if (!options.student.empty()) all["extra_data"]["student"] = options.student;
  if (!options.handed_in.empty()) all["extra_data"]["handed_in"] = options.handed_in;
  return all;
}

Json prairielearn_test(const CaseResult& one) {
  return {{"name", text_of(one.name)},
          {"points", rounded_points(one.points)},
          {"max_points", rounded_points(one.max_points)},
          {"message", text_of(one.feedback)}};
}

Json prairielearn_pictures(const std::vector<PictureResult>& pictures) {
  Json all = Json::array();
  const auto add = [&](const std::string& label, const std::string& png) {
    if (!png.empty()) all.push_back({{"label", text_of(label)}, {"url", data_address(png)}});
  };
  for (const PictureResult& one : pictures) {
    add(one.name + ": yours", one.student);
    if (one.heat.empty()) continue;
    add(one.name + ": the reference's", one.reference);
    add(one.name + ": where they differ", one.heat);
  }
  return all;
}

std::string json_text(const Json& all) {
  return all.dump(1, ' ', true, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string prairielearn_json(const SubmissionResult& result, const std::string& id, bool pictures) {
  const SubmissionResult shown = for_student(result);
  const auto exercise = std::ranges::find(shown.exercises, id, &ExerciseResult::id);
  if (exercise == shown.exercises.end())
    return json_text({{"gradable", false}, {"format_errors", {text_of(said_of_the_whole(shown))}}});
  const std::string said = text_of(joined(said_of_exercise(*exercise), exercise->compiler_messages));
  if (exercise->cases.empty()) return json_text({{"gradable", false}, {"format_errors", {said}}});
  Json all = {{"gradable", true},
              {"score", std::clamp(exercise->points / exercise->max_points, 0.0, 1.0)},
              {"message", said},
              {"tests", Json::array()}};
  std::ranges::transform(exercise->cases, std::back_inserter(all["tests"]), prairielearn_test);
  if (pictures) all["images"] = prairielearn_pictures(exercise->pictures);
  const std::string text = json_text(all);
  return text.size() <= kMostResultsBytes || !pictures ? text : prairielearn_json(result, id, false);
}

std::string student_json(const SubmissionResult& whole, const ResultsOptions& options) {
  const SubmissionResult result = options.public_checks ? whole : for_student(whole);
  const std::string text = json_text(json_of(result, options));
  if (!options.pictures || text.size() <= kMostResultsBytes) return text;
  ResultsOptions without = options;
  without.pictures = false;
  return student_json(whole, without);
}

}  // namespace grader::report
