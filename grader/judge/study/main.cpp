// STAFF ONLY. Measures error against time of a submission. The job names all of its objects and all of the
// reference's; the program links the reference, and never a student's code.
#include <limits>

#include "grader/judge/study/submission_study.h"
#include "grader/judge/suite_program.h"
#include "grader/sandbox/inherited.h"

namespace {

using grader::SuiteJob, grader::SuiteResult;

SuiteResult run(const SuiteJob& job) {
  grader::WorkerSetup worker = grader::worker_of(job);
  worker.cpu_seconds = grader::study_cpu_seconds();
  // The instructor asks for a study, so the submission's budget does not bound it.
  grader::Budget& limit = worker.allowance->limit;
  limit.worker_cpu_seconds = limit.suite_cpu_seconds = worker.cpu_seconds;
  limit.wall_seconds = std::numeric_limits<double>::infinity();  // a study has a clock of its own

  grader::WorkerSetup of_reference = worker;
  of_reference.objects = job.reference_objects;
  of_reference.allowance = std::make_shared<grader::Allowance>(grader::Allowance{limit});

  grader::Student student(worker), reference(of_reference);
  SuiteResult result;
  result.study = grader::study_submission(student, reference, {job.left_out, job.unavailable}, job.motions);
  add_costs(student, worker, result);
  return result;
}

}  // namespace

int main(int /*argc*/, char* argv[]) {
  grader::set_what_is_inherited(argv);
  return grader::run_suite_program("hairstudy", run);
}
