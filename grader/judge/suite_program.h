// STAFF ONLY. hairsuite and hairstudy as programs: each reads a job as JSON from standard input (job.h) and
// writes its results as JSON to standard output (grader/result/suite_result.h).
#pragma once

#include "grader/judge/job.h"
#include "grader/judge/student/student.h"
#include "grader/result/suite_result.h"

namespace grader::inline judge {

WorkerSetup worker_of(const SuiteJob& job);

// Ends the student's process; adds the costs of it and of this job.
void add_costs(Student& student, const WorkerSetup& worker, SuiteResult& result);

// Returns the program's exit code: 2 if the job is malformed, 1 if `run` throws. It ends with the program
// that started it.
int run_suite_program(const char* name, SuiteResult (*run)(const SuiteJob&));

}  // namespace grader::judge
