// STAFF ONLY.
#include "grader/tool/end_to_end_grading.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

// Why an exercise of a submission is not called in scenes that run end to end; nothing if it is.
std::string why_not_called(Status status) {
  switch (status) {
    case Status::missing:
      return "is missing";
    case Status::not_implemented:
      return "is not implemented yet";
    case Status::does_not_compile:
      return "does not compile";
    case Status::timed_out:
      return "takes too long";
    case Status::out_of_memory:
      return "takes too much memory";
    case Status::broke_rules:
      return "breaks the rules";
    case Status::unreadable:
      return "can't be read";
    default:
      return "";
  }
}

}  // namespace

SuiteJob end_to_end_job(const SuiteJobs& jobs, const fs::path& job, const SubmissionResult& result) {
  const StagedKit& kit = jobs.kit();
  SuiteJob suite = jobs.end_to_end(kit.new_job(job.filename() / kRuns));
  for (const Exercise& exercise : jobs.settings().course.exercises) {
    const std::string file = exercise.id + ".so";
    fs::path object = kit.folder() / (exercise.role == Role::given ? "lib" : "stub") / file;
    if (exercise.role == Role::absent) suite.left_out.insert(exercise.id);
    for (const ExerciseResult& graded : result.exercises) {
      if (graded.id != exercise.id) continue;
      const fs::path compiled = job / exercise.id / file;
      std::string why = why_not_called(graded.status);
      if (why.empty() && !fs::exists(compiled)) why = "could not be graded";
      if (why.empty())
        object = compiled;
      else
        suite.unavailable[exercise.id] = why;
    }
    suite.objects.push_back(object);
  }
  return suite;
}

}  // namespace grader
