// STAFF ONLY. Reads Gradescope's metadata of a hand-in, and writes the results that it shows.
#include "grader/tool/gradescope_hand_in.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "grader/course/input.h"

namespace grader::inline tool {
namespace {

constexpr long kLargestId = 1L << 53;  // JSON's numbers are whole up to there

JsonValue member(const JsonValue& object, const std::string& key) {
  if (!object.value().is_object() || !object.has(key))
    object.fail("it must be an object with \"" + key + "\"");
  return object[key];
}

}  // namespace

Metadata read_metadata(const std::filesystem::path& file) {
  const hair::JsonDocument document = hair::read_document(file);
  const JsonValue metadata(*document, file);
  const std::vector<JsonValue> users = member(metadata, "users").items();
  if (users.empty()) metadata["users"].fail("there is nobody; it must name who handed in");
  long smallest = kLargestId;
  for (const JsonValue& user : users)
    smallest = std::min(smallest, member(user, "id").whole_number(1, kLargestId));
  return {std::to_string(smallest), member(metadata, "created_at").text()};
}

GradescopeResults::GradescopeResults(const std::filesystem::path& folder, const Course& course,
                                     ResultsOptions options)
    : file_(folder / "results" / "results.json"), course_(course), options_(std::move(options)) {
  write({});
}

void GradescopeResults::belong_to(const Metadata& metadata) {
  options_.student = metadata.student;
  options_.handed_in = metadata.created_at;
}

void GradescopeResults::write(SubmissionResult result) const {
  std::string left;
  for (const Exercise& exercise : course_.exercises)
    if (course_.asks_for(exercise) &&
        std::ranges::find(result.exercises, exercise.id, &ExerciseResult::id) == result.exercises.end())
      left += (left.empty() ? "" : ", ") + exercise.id;
  if (!left.empty())
    left = "Not graded, since the time was over before: " + left +
           ". They have no points yet. Tell the staff, who can grade them.";
  write_with_note(std::move(result), left);
}

void GradescopeResults::could_not_grade() const {
  write_with_note({}, kCouldNotGrade);
}

void GradescopeResults::write_with_note(SubmissionResult result, const std::string& note) const {
  result.note += (result.note.empty() || note.empty() ? "" : "\n\n") + note;
  write_file(file_, student_json(result, options_));
}

}  // namespace grader::tool
