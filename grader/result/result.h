// STAFF ONLY. The results of grading, as plain data: the suite and the build make them, the reports read
// them.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "grader/course/isolation.h"

namespace grader::inline result {

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
  not_taken,   // a person must say which part of the hand-in counts
  unreadable,  // the whole submission, such as a .rar
  given,       // points by hand (HandInRules::by_hand), which a person gave
  not_given,   // has not given yet: the total is not final
  excused,     // by a person: it does not count
};

// This is the title of the category that judges the whole run and its pictures.
inline constexpr const char* kRunTitle = "The whole run";

std::string to_string(Status status);     // "does not compile"
std::string sentence_for(Status status);  // helps the student without revealing hidden cases

// Counts the moments of a whole run that are drawn. A run that ends early has fewer, and its last one before
// the end.
inline constexpr std::size_t kRunPictures = 3;

// Stands for an error that is no number, or whose limit is 0.
inline constexpr double kNoNumber = std::numeric_limits<double>::max();

// This is one category of an exercise's hidden cases.
struct CaseResult {
  std::string name = {};  // for students: "Ill-conditioned systems"
  Status status = Status::wrong;
  double points = 0, max_points = 0;
  std::string feedback = {};  // for staff, until for_student writes the student's
  std::string detail = {};    // for staff: inputs, expected and actual values
  // For students, too: a likely mistake in its numbers, or the end of its run, in one of our few sentences.
  // Empty: nothing is clear.
  std::string hint = {};
  // Count the cases of a wrong category, and those that hold; 0 of 0 if they could not be counted.
  int cases = 0, held = 0;
  // For staff: is the error of a wrong category over its limit; 0: it has none.
  double error_in_limits = 0;

  bool operator==(const CaseResult&) const = default;
};

// This is a moment of a run. We draw it from the states of the submission's code and of the reference. It
// contains no text and no name from a student.
struct PictureResult {
  std::string name = {};                 // "0.50 s"
  double blurred_rmse = 0, flip = 0;     // 0 to 1, see compare/compare.h; flip: the mean
  std::string student, reference, heat;  // PNG files' bytes; heat is empty if both pictures are the same
  // True if its particles are far from the reference's: students see it coarsely (student_view.h).
  bool far_off = false;
  bool breaks_off = false;  // the run has no later moment that can be drawn
  // This is the largest distance of a point from the reference's, in per cent of the longest strand; of the
  // scene's size if it has no strands.
  double apart = 0;

  bool operator==(const PictureResult&) const = default;
};

// Holds the motions of a whole run, if they look different. They contain no text from a student.
struct RunMotions {
  std::string student, reference;  // for staff: JSON of hair/view/motion.h
  std::string film;                // for students: a PNG file with both (grader/judge/run/run_pictures.h)

  bool operator==(const RunMotions&) const = default;
};

// This is said by the staff at a place of an exercise, or asked there.
struct Said {
  std::string place;  // "H2", "H2.3", or "H2:17", a line of its file
  std::string code;   // is that line, when it was said
  std::string text;

  bool operator==(const Said&) const = default;
};

struct ExerciseResult {
  std::string id = {}, title = {}, file = {};
  bool extra_credit = false;  // an optional exercise: its points are added on top of the total
  bool points_set = false;    // a person gave points of it (SubmissionResult::decided)
  Status status = Status::missing;
  double points = 0, max_points = 0;
  std::string feedback = {};           // for students
  std::string compiler_messages = {};  // for students: the compiler's messages about their own lines
  std::vector<CaseResult> cases = {};
  std::vector<PictureResult> pictures = {};  // show the whole run
  RunMotions motions = {};                   // the same
  std::string staff_log = {};                // the whole output of compiler, linker and worker
  std::string source = {};                   // is the beginning of the student's file
  std::vector<Said> said = {};               // by people, for students, too

  bool operator==(const ExerciseResult&) const = default;
};

// This is a change of the total that no exercise makes, such as lateness: a line of its own.
struct Adjustment {
  std::string reason;  // is for the student: "Late by 2 days: 10 per cent of the points a day"
  double points = 0;   // below 0: taken off

  bool operator==(const Adjustment&) const = default;
};

// This is the lateness of a hand-in, and the points that the course's rules took for it.
struct Lateness {
  std::string handed_in;  // as in the download; "": it has no time
  int days = 0;           // begun days of the calendar; 0: not late, or unknown
  double free_days = 0;   // are a part of these
  double taken = 0;       // are points
  bool marked = false;    // by the learning system

  bool operator==(const Lateness&) const = default;
};

// This is a decision of a person, for staff (grader/record/points/decisions.h).
struct Decided {
  std::string place, kind;  // "H2.3", "points"; place "": the whole
  std::string text;         // is the decision in a line
  std::string conflict;     // says why it may be out of date; "": it is not

  bool operator==(const Decided&) const = default;
};

struct SubmissionResult {
  std::string name = {};
  std::string origin = {};  // see grader/intake/submission.h; for staff
  std::vector<ExerciseResult> exercises = {};
  std::string note = {};         // not empty: an error of the whole submission, for the student
  std::string fingerprint = {};  // hashes the submission's bytes and the suite, in hexadecimal
  Isolation isolation = Isolation::namespaces;  // every page names any other kind
  bool images = true;                           // false: graded without pictures; every page says so
  // Lists exercises that ended by wall time: their points are not final, and a person looks.
  std::vector<std::string> ended_by_the_clock = {};
  bool studied = false;                             // there is a study.html, to which pages link
  std::optional<double> extra_credit_counted = {};  // nothing: all of it counts
  std::vector<Adjustment> adjustments = {};
  std::vector<std::string> remarks = {};  // for the student: the staff's, and the choice among several files
  std::vector<Decided> decided = {};      // are in the points; computed results have none
  std::string about = {};  // is the student's about.txt (report/facts/about.h), for staff; readable text

  bool operator==(const SubmissionResult&) const = default;
};

bool is_by_hand(const ExerciseResult&);    // people give its points
bool is_given(const ExerciseResult&);      // false: its points are still to come
bool has_points(const ExerciseResult&);    // false: it is excused, too
bool is_excused(const SubmissionResult&);  // from an exercise at least: its total has no place in a mean

// True if its whole run ended before its last picture: then its pictures, if there are any, say too little.
bool run_breaks_off(const ExerciseResult&);

double points(const SubmissionResult&);        // includes adjustments and the extra credit that counts
double max_points(const SubmissionResult&);    // leaves out extra credit
double extra_credit(const SubmissionResult&);  // includes all that was reached
double extra_credit_counted(const SubmissionResult&);  // is the part of it that counts

// Returns how much of `extra` counts besides `others`: at most `most_extra`, and not above `most` together.
double counted(double extra, double others, double most_extra, double most);

}  // namespace grader::result
