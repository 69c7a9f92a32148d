// STAFF ONLY. Error against time of a submission's code, as a program that takes a job with all of its
// objects and all of the reference's: links the reference, and never a student's code.
#include <algorithm>
#include <cmath>
#include <limits>

#include "grader/judge/study/study.h"
#include "grader/judge/suite_program.h"
#include "grader/sandbox/inherited.h"

namespace {

using namespace grader;

// The CPU time limit of a worker. Each part may take most_seconds, plus the play that starts before they are
// used up: with twice the steps of the previous play, it takes about as long as all plays before it together.
int study_cpu_seconds(const StudySettings& settings) {
  std::size_t parts = 0;
  for (const SceneText& text : studied_scenes()) parts += parts_of(text).size();
  return static_cast<int>(std::ceil(2 * settings.most_seconds * static_cast<double>(parts)));
}

// "H4 does not compile.", or empty.
std::string why_not_run(const std::vector<std::string>& exercises,
                        const std::map<std::string, std::string>& unavailable) {
  std::string all;
  for (const std::string& id : exercises)
    if (const auto why = unavailable.find(id); why != unavailable.end())
      all += (all.empty() ? "" : ", ") + id + " " + why->second;
  return all.empty() ? all : all + ".";
}

// All scenes, one after the other. Scenes that can't be run have a reason in the result, and are not played;
// those that need an exercise that the course leaves out are none of it.
SubmissionStudy study_submission(Student& student, Student& reference, const SuiteJob& job,
                                 const StudySettings& settings) {
  WorkerPlayer their_worker(student), ours(reference);
  UntilItGivesUp theirs(their_worker, settings.most_wall_seconds);
  SubmissionStudy study;
  for (const SceneText& text : studied_scenes()) {
    const hair::Scene scene = hair::parse_scene(text.json, text.name);
    const std::vector<std::string> exercises = hair::exercises_of(scene);
    if (std::ranges::any_of(exercises, [&](const std::string& id) { return job.left_out.contains(id); }))
      continue;
    SceneStudy& one = study.scenes.emplace_back(SceneStudy{text.name, scene.shows});
    one.left_out = why_not_run(exercises, job.unavailable);
    if (!one.left_out.empty()) continue;
    for (const StudiedPart& part : parts_of(text))
      one.parts.push_back(study_part(part, true_motion(part, job.motions), theirs, ours, settings));
  }
  student.finish();
  reference.finish();
  study.student_seconds = student.cpu_seconds();
  study.reference_seconds = reference.cpu_seconds();
  return study;
}

SuiteResult run(const SuiteJob& job) {
  const StudySettings settings;
  WorkerSetup worker = worker_of(job);
  worker.cpu_seconds = study_cpu_seconds(settings);
  // Asked for by the instructor, beside the submission's budget.
  Budget& limit = worker.allowance->limit;
  limit.worker_cpu_seconds = limit.suite_cpu_seconds = worker.cpu_seconds;
  limit.wall_seconds = std::numeric_limits<double>::infinity();  // a study has a clock of its own

  WorkerSetup of_reference = worker;
  of_reference.objects = job.reference_objects;
  of_reference.allowance = std::make_shared<Allowance>(Allowance{limit});

  Student student(worker), reference(of_reference);
  SuiteResult result;
  result.study = study_submission(student, reference, job, settings);
  add_costs(student, worker, result);
  return result;
}

}  // namespace

int main(int /*argc*/, char* argv[]) {
  set_what_is_inherited(argv);
  return run_suite_program("hairstudy", run);
}
