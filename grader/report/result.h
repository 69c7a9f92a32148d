// STAFF ONLY. What grading found, as plain data: made by the suite and the build, read by the reports.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace grader {

enum class Status {
  passed,
  partly,
  wrong,
  not_implemented,
  missing,
  does_not_compile,
  crashed,
  timed_out,
  out_of_memory,
  broke_rules,
};

std::string to_string(Status status);           // "does not compile"
Status status_from_string(const std::string&);  // throws std::invalid_argument
std::string sentence_for(Status status);        // helps the student, gives nothing away

// One category of an exercise's hidden cases.
struct CaseResult {
  std::string name;  // for students: "Ill-conditioned systems"
  Status status = Status::wrong;
  double points = 0, max_points = 0;
  std::string feedback;  // for students: category and size of the error in bands, never a value or an input
  std::string detail;    // for staff: inputs, expected and actual values
};

// A moment of a run, drawn by us from the states that a submission's code reached and from the reference's.
// No text and no name of a student's is in it.
struct PictureResult {
  std::string name;                      // "0.50 s"
  double blurred_rmse = 0, flip = 0;     // 0 to 1, see compare/compare.h; flip: the mean
  std::string student, reference, heat;  // PNG files' bytes; heat is empty where the two are the same
  // The largest that give points; 0: shown, and not scored.
  double blurred_rmse_limit = 0, flip_limit = 0;
};

struct ExerciseResult {
  std::string id, title, file;
  bool extra_credit = false;  // an optional exercise: its points are not in the total to reach
  Status status = Status::missing;
  double points = 0, max_points = 0;
  std::string feedback;           // for students
  std::string compiler_messages;  // for students: what the compiler says about their own lines
  std::vector<CaseResult> cases;
  std::vector<PictureResult> pictures;  // of the whole run
  std::string staff_log;                // all that compiler, linker and worker printed
};

enum class RunOutcome { same, differs, blew_up, failed, not_run };

std::string to_string(RunOutcome outcome);               // "blew up"
RunOutcome run_outcome_from_string(const std::string&);  // throws std::invalid_argument

// A scene that all of a submission's exercises run together: shown, and not scored.
struct RunResult {
  std::string name, shows;  // "strand-swing", and what there is to see
  RunOutcome outcome = RunOutcome::not_run;
  std::string feedback;  // for students
  std::string detail;    // for staff
  std::vector<PictureResult> pictures = {};
};

struct SubmissionResult {
  std::string name;
  std::vector<ExerciseResult> exercises;
  std::vector<RunResult> runs;
  std::string note;         // not empty: what is wrong with the submission as a whole, for the student
  std::string fingerprint;  // of the submission's bytes and of the suite, in hexadecimal
  bool isolated = true;     // false: graded without a sandbox; every page says so
  bool images = true;       // false: graded without pictures; every page says so
  bool studied = false;     // there is a study.html, which pages lead to
};

bool too_far(const PictureResult&);  // over a limit

double points(const SubmissionResult&);
double max_points(const SubmissionResult&);  // without extra credit

// The largest FLIP of the exercises' pictures; nothing without pictures.
std::optional<double> picture_distance(const SubmissionResult&);

}  // namespace grader
