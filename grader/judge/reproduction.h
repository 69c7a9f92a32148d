// STAFF ONLY. Runs a category until its first case fails, and writes that case as a program that needs no
// grader: the inputs as literals, the calls, the expected numbers.
#pragma once

#include <map>
#include <string>

#include "grader/judge/cases/trial.h"
#include "grader/judge/job.h"

namespace grader::inline judge {

// Returns files by name, or kNotReproduced. `student` runs the job's object.
std::map<std::string, std::string> reproduce(const SuiteJob& job, Student& student);

}  // namespace grader::judge
