// STAFF ONLY. Reads a job, runs it and writes its results.
#include "grader/judge/suite_program.h"

#include <signal.h>
#include <sodium.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <iostream>
#include <iterator>

#include "grader/course/input.h"
#include "grader/result/json_fields.h"
#include "grader/result/result_fields.h"
#include "grader/sandbox/inherited.h"

namespace grader::inline judge {

WorkerSetup worker_of(const SuiteJob& job) {
  WorkerSetup worker;
  worker.exercise = job.exercise;
  worker.kit = job.kit;
  worker.provided = job.provided;
  worker.objects = job.objects;
  worker.log = job.log;
  worker.isolation = job.isolation;
  worker.cpu_seconds = job.cpu_seconds;
  worker.allowance->limit = job.allowance;
  return worker;
}

void add_costs(Student& student, const WorkerSetup& worker, SuiteResult& result) {
  student.finish();
  result.cpu_seconds = student.cpu_seconds();
  result.starts = student.starts();
  result.spent = worker.allowance->spent;
}

int run_suite_program(const char* name, SuiteResult (*run)(const SuiteJob&)) {
  // This process and its worker end when hairgrade ends, for whatever reason.
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  signal(SIGPIPE, SIG_IGN);
  for (int ending : {SIGINT, SIGTERM, SIGHUP})
    if (!is_ignored(ending)) signal(ending, [](int number) { _exit(128 + number); });
  if (sodium_init() < 0) return 1;
  try {
    const std::string job(std::istreambuf_iterator<char>(std::cin), {});
    std::cout << json_text(run(suite_job_from_json(job, "standard input")), -1) << std::flush;
    return 0;
  } catch (const BadInput& error) {
    std::cerr << name << ": " << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << "\n";
    return 1;
  }
}

}  // namespace grader::judge

// In a build with sanitisers the search for leaks at the end fails now and then because of OSMesa's threads,
// and a submission would have no result. The suite's own tests look for leaks in the same code.
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming): the sanitiser's name
extern "C" int __lsan_is_turned_off() {
  return 1;
}
