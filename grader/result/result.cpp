// STAFF ONLY. Sums points, and puts statuses and ends into words.
#include "grader/result/result.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>

#include "grader/result/study.h"

namespace grader::inline result {
namespace {

struct Wording {
  const char* name;
  const char* sentence;
};

// The order is that of Status.
constexpr std::array<Wording, 15> wordings{{
    {"passed", "Everything passes. Well done."},
    {"partly",
     "Part of this works. The categories below say where points are left; each can be won on its own."},
    {"wrong",
     "The code runs, but no category passes yet. Start with the public checks: they run in a debugger on "
     "your machine."},
    {"not implemented",
     "The stub is still in place, so there was nothing to grade. The assignment text leads you in, step by "
     "step."},
    {"missing",
     "The file was not in what you handed in. Build the target `handin`: it packs every file that is "
     "needed."},
    {"does not compile",
     "The file does not compile on its own with the given headers. The compiler's first message is the one "
     "to begin with."},
    {"crashed",
     "The program ended in the middle of a call, as after a write outside an array. The debug preset shows "
     "the line."},
    {"timed out",
     "A call did not return within a generous limit. Check that every loop ends, also when the system can't "
     "be solved."},
    {"out of memory",
     "The code asked for more memory than it was given. A few vectors of length n are all that is needed; "
     "free what you allocate."},
    {"broke the rules",
     "The code did something that an exercise may not do, such as starting a program (system(\"pause\") "
     "does), "
     "or opening files or connections. It needs only to compute and return."},
    {"not taken",
     "A person must first say which of your files counts here, so nothing was graded yet. The staff know."},
    {"can't be read",
     "What you handed in could not be read, so nothing in it was graded. Pack the exercise files into a .zip "
     "or "
     "a .tar.gz, and check that it opens."},
    {"given", "A person gave these points."},
    {"not given yet", "A person will give these points."},
    {"excused", "This exercise does not count for you."},
}};

const Wording& wording_of(Status status) {
  return wordings.at(static_cast<std::size_t>(status));
}

}  // namespace

std::string to_string(StudyEnd end) {
  constexpr std::array kNames{"finished", "ran away", "broke"};
  return kNames.at(static_cast<std::size_t>(end));
}

std::string to_string(Status status) {
  return wording_of(status).name;
}

std::string sentence_for(Status status) {
  return wording_of(status).sentence;
}

bool is_by_hand(const ExerciseResult& exercise) {
  return exercise.status == Status::given || exercise.status == Status::not_given;
}

bool is_given(const ExerciseResult& exercise) {
  return exercise.status != Status::not_given;
}

double points(const SubmissionResult& result) {
  double sum = extra_credit_counted(result);
  for (const ExerciseResult& exercise : result.exercises) sum += exercise.extra_credit ? 0 : exercise.points;
  for (const Adjustment& adjustment : result.adjustments) sum += adjustment.points;
  return sum;
}

bool has_points(const ExerciseResult& exercise) {
  return is_given(exercise) && exercise.status != Status::excused;
}

bool is_excused(const SubmissionResult& result) {
  return std::ranges::any_of(result.exercises,
                             [](const ExerciseResult& one) { return one.status == Status::excused; });
}

double max_points(const SubmissionResult& result) {
  return std::accumulate(result.exercises.begin(), result.exercises.end(), 0.0,
                         [](double sum, const ExerciseResult& exercise) {
                           return exercise.extra_credit ? sum : sum + exercise.max_points;
                         });
}

double extra_credit(const SubmissionResult& result) {
  double sum = 0;
  for (const ExerciseResult& exercise : result.exercises) sum += exercise.extra_credit ? exercise.points : 0;
  return sum;
}

double extra_credit_counted(const SubmissionResult& result) {
  return result.extra_credit_counted.value_or(extra_credit(result));
}

double counted(double extra, double others, double most_extra, double most) {
  return std::min({extra, most_extra, most - others});
}

bool run_breaks_off(const ExerciseResult& exercise) {
  if (std::ranges::any_of(exercise.pictures, &PictureResult::breaks_off)) return true;
  if (exercise.pictures.size() >= kRunPictures) return false;
  return std::any_of(exercise.cases.begin(), exercise.cases.end(), [](const CaseResult& one) {
    return one.name == kRunTitle && one.status != Status::passed && one.status != Status::wrong &&
           one.status != Status::not_implemented;
  });
}

}  // namespace grader::result
