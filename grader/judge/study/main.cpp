// STAFF ONLY. Measures error against time of a submission. The job names all of its objects and all of the
// reference's; the program links the reference, and never a student's code.
#include <algorithm>
#include <cmath>
#include <limits>

#include "grader/judge/study/study.h"
#include "grader/judge/suite_program.h"
#include "grader/sandbox/inherited.h"

namespace {

using namespace grader;

// Limits a worker's CPU time. Each part may take most_seconds, plus the run that starts before they end: with
// twice the steps of the previous run, it takes about as long as all runs before it together.
int study_cpu_seconds(const StudySettings& settings) {
  std::size_t parts = 0;
  for (const SceneText& text : studied_scenes()) parts += parts_of(text).size();
  return static_cast<int>(std::ceil(2 * settings.most_seconds * static_cast<double>(parts)));
}

// Returns "H4 does not compile.", or an empty text.
std::string why_not_run(const std::vector<std::string>& exercises,
                        const std::map<std::string, std::string>& unavailable) {
  std::string all;
  for (const std::string& id : exercises)
    if (const auto why = unavailable.find(id); why != unavailable.end())
      all += (all.empty() ? "" : ", ") + id + " " + why->second;
  return all.empty() ? all : all + ".";
}

// Studies all scenes, one after the other. Scenes that can't run have a reason in the result; the result
// lacks scenes that need an exercise that the course leaves out.
SubmissionStudy study_submission(Student& student, Student& reference, Student& twin, const SuiteJob& job,
                                 const StudySettings& settings) {
  WorkerRunner their_worker(student), ours(reference), ours_again(twin);
  UntilItGivesUp theirs(their_worker, settings.most_wall_seconds);
  SubmissionStudy study;
  for (const SceneText& text : studied_scenes()) {
    const hair::Scene scene = hair::parse_scene(text.json, text.name);
    const std::vector<std::string> exercises = hair::exercises_of(scene);
    if (std::ranges::any_of(exercises, [&](const std::string& id) { return job.left_out.contains(id); }))
      continue;
    SceneStudy& one = study.scenes.emplace_back(SceneStudy{text.name, scene.shows});
    one.exercises = exercises;
    one.left_out = why_not_run(exercises, job.unavailable);
    if (!one.left_out.empty()) continue;
    for (const StudiedPart& part : parts_of(text))
      one.parts.push_back(
          study_part(part, true_motion(part, job.motions), theirs, ours, ours_again, settings));
  }
  student.finish();
  reference.finish();
  twin.finish();
  study.student_seconds = student.cpu_seconds();
  study.reference_seconds = reference.cpu_seconds();
  return study;
}

SuiteResult run(const SuiteJob& job) {
  const StudySettings settings;
  WorkerSetup worker = worker_of(job);
  worker.cpu_seconds = study_cpu_seconds(settings);
  // The instructor asks for a study, so the submission's budget does not bound it.
  Budget& limit = worker.allowance->limit;
  limit.worker_cpu_seconds = limit.suite_cpu_seconds = worker.cpu_seconds;
  limit.wall_seconds = std::numeric_limits<double>::infinity();  // a study has a clock of its own

  WorkerSetup of_reference = worker;
  of_reference.objects = job.reference_objects;
  of_reference.allowance = std::make_shared<Allowance>(Allowance{limit});

  Student student(worker), reference(of_reference), twin(of_reference);
  SuiteResult result;
  result.study = study_submission(student, reference, twin, job, settings);
  add_costs(student, worker, result);
  return result;
}

}  // namespace

int main(int /*argc*/, char* argv[]) {
  set_what_is_inherited(argv);
  return run_suite_program("hairstudy", run);
}
