// STAFF ONLY. A hand-in in Gradescope's folders: FOLDER/submission, with FOLDER/submission_metadata.json
// beside it. Results go to FOLDER/results/results.json, which is complete at each moment: if the platform's
// time limit ends the run, it keeps the finished exercises and names the others.
//
// The student is a number of Gradescope's, and the inputs are drawn from it: of a group the smallest of its
// members', whoever of them hands in.
//
// If nothing can be graded (odd metadata, no isolation, a fault of ours), results.json gives no points, and
// says in a line that this is not the student's fault. The reason is for the staff, who read hairgrade's
// output on the platform; students don't.
#pragma once

#include <filesystem>
#include <string>

#include "grader/course/course.h"
#include "grader/report/results_json.h"

namespace grader::inline tool {

inline constexpr const char* kCouldNotGrade =
    "The grader could not grade this, and that is not your fault. Tell the staff, who see why.";

struct Metadata {
  std::string student;     // "4711"
  std::string created_at;  // "2026-03-04T10:15:00.000000-08:00": the time of the hand-in
};

// Throws BadInput with the file, the JSON path and what would be right.
Metadata read_metadata(const std::filesystem::path& file);

class GradescopeResults {
 public:
  // Writes results.json, in which nothing is graded yet.
  GradescopeResults(const std::filesystem::path& folder, const Course& course, ResultsOptions options);

  void belong_to(const Metadata& metadata);
  // Writes a result so far, and names the missing exercises.
  void write(SubmissionResult result) const;
  void could_not_grade() const;

 private:
  void write_with_note(SubmissionResult result, const std::string& note) const;

  std::filesystem::path file_;
  const Course& course_;
  ResultsOptions options_;
};

}  // namespace grader::tool
