// STAFF ONLY. Writes reports as text.
#include "grader/report/facts/student_text.h"

#include "grader/report/facts/columns.h"
#include "grader/report/facts/student_view.h"
#include "grader/report/facts/text.h"
#include "hair/io/plot/readable.h"

namespace grader::inline report {
namespace {

std::string total_of(const SubmissionResult& result) {
  const std::string to_come = not_given_yet(result);
  return shown_total(points(result), max_points(result)) + (to_come.empty() ? "" : ", not final: " + to_come);
}

std::string line_of(const ExerciseResult& exercise) {
  return exercise.id + " " + exercise.title + ": " + shown_points(exercise.points) + " of " +
         shown_points(exercise.max_points) + ", " + to_string(exercise.status);
}

}  // namespace

std::string about(const Said& said, const ExerciseResult& exercise) {
  const std::size_t end = said.place.find_first_of(".:");
  if (end == said.place.npos) return "";
  const std::string number = said.place.substr(end + 1);
  if (said.place[end] == ':') return exercise.file + ", line " + number + ": ";
  return said.place + " " + exercise.cases.at(std::stoul(number) - 1).name + ": ";
}

std::string said_of_exercise(const ExerciseResult& exercise) {
  std::string all = exercise.feedback;
  for (const Said& said : exercise.said)
    all += (all.empty() ? "" : "\n") + about(said, exercise) + (said.code.empty() ? "" : said.code + "\n") +
           said.text;
  return all;
}

std::string joined(const std::string& first, const std::string& second) {
  return first.empty() || second.empty() ? first + second : first + "\n\n" + second;
}

std::string said_of_the_whole(const SubmissionResult& result) {
  std::string all = result.note;
  for (const Adjustment& adjustment : result.adjustments)
    all = joined(all, adjustment.reason + ": " + shown_points(adjustment.points) + " points.");
  for (const std::string& remark : result.remarks) all = joined(all, remark);
  return all;
}

std::string student_text(const SubmissionResult& whole) {
  const SubmissionResult result = for_student(whole);
  std::string text = total_of(result) + "\n";
  if (const std::string said = said_of_the_whole(result); !said.empty()) text += hair::readable(said) + "\n";
  for (const ExerciseResult& exercise : result.exercises) {
    text += "\n" + line_of(exercise) + "\n";
    if (const std::string said = said_of_exercise(exercise); !said.empty())
      text += hair::readable(said) + "\n";
    if (!exercise.compiler_messages.empty()) text += hair::readable(exercise.compiler_messages) + "\n";
    std::size_t number = 0;
    for (const CaseResult& one : exercise.cases) {
      text += "  " + exercise.id + "." + std::to_string(++number) + " " + one.name + ": " +
              shown_points(one.points) + " of " + shown_points(one.max_points) + ", " +
              to_string(one.status) + "\n";
      if (!one.feedback.empty()) text += "    " + hair::readable(one.feedback) + "\n";
    }
  }
  return text;
}

std::string first_lines(const SubmissionResult& whole) {
  const SubmissionResult result = for_student(whole);
  std::string text = total_of(result);
  for (const ExerciseResult& exercise : result.exercises) text += ". " + line_of(exercise);
  return text;
}

}  // namespace grader::report
