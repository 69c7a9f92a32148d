// STAFF ONLY. Removes from a result what students may not see.
#include "grader/report/facts/student_view.h"

#include <algorithm>

#include "grader/compare/montage.h"
#include "hair/io/image/read_png.h"

namespace grader::inline report {
namespace {

Status right_wrong_or_broke_off(Status status) {
  return status == Status::passed || status == Status::wrong ? status : Status::crashed;
}

// A stub implements nothing. Code that implements only some categories breaks off in the others.
bool is_stub(const ExerciseResult& exercise) {
  return std::all_of(exercise.cases.begin(), exercise.cases.end(),
                     [](const CaseResult& one) { return one.status == Status::not_implemented; });
}

// Returns one of three bands. If there are few cases, it would show which ones hold.
std::string how_many_hold(const CaseResult& one) {
  constexpr int kFew = 5;
  constexpr double kNearlyAll = 0.8, kHardlyAny = 0.2;
  if (one.cases < kFew) return "Not right.";
  const double share = static_cast<double>(one.held) / one.cases;
  return share >= kNearlyAll   ? "Not right, but nearly all of its cases are."
         : share >= kHardlyAny ? "Not right, but some of its cases are."
                               : "Not right: hardly any of its cases is.";
}

std::string sentence_of(const CaseResult& one) {
  const std::string hint = one.hint.empty() ? "" : " " + one.hint;
  switch (one.status) {
    case Status::passed:
      return "";
    case Status::not_implemented:
      return "Not implemented yet.";
    case Status::wrong:
      return how_many_hold(one) + hint;
    default:
      return "It broke off: no answer, or none of the kind that was asked for." + hint;
  }
}

// Says once for an exercise how to go on.
std::string next_step(const ExerciseResult& exercise) {
  if (exercise.status != Status::partly && exercise.status != Status::wrong) return "";
  return " check-" + exercise.id +
         " asks the same, with inputs that you can see, and its last line is the command that shows the "
         "exercise. If all of it passes, compare your code with the "
         "header's "
         "sentences on what a category below names.";
}

std::string coarse(const std::string& png) {
  if (png.empty()) return png;
  return hair::encode_png(shrunk(hair::decode_png(png, "a picture"), kCoarseWidth));
}

}  // namespace

SubmissionResult for_student(const SubmissionResult& result) {
  SubmissionResult view = result;
  view.decided.clear();
  for (ExerciseResult& exercise : view.exercises) {
    exercise.staff_log.clear();
    exercise.source.clear();
    exercise.motions.student.clear();
    exercise.motions.reference.clear();
    if (exercise.feedback.empty()) exercise.feedback = sentence_for(exercise.status);
    exercise.feedback += next_step(exercise);
    const bool stub = is_stub(exercise);
    for (CaseResult& one : exercise.cases) {
      if (!stub) one.status = right_wrong_or_broke_off(one.status);
      one.feedback = sentence_of(one);
      one.hint.clear();
      one.detail.clear();
      one.error_in_limits = 0;
      one.cases = one.held = 0;
    }
    for (PictureResult& picture : exercise.pictures) {
      if (!picture.far_off) continue;
      picture.student = coarse(picture.student);
      picture.heat = coarse(picture.heat);
    }
  }
  return view;
}

}  // namespace grader::report
