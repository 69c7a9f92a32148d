// STAFF ONLY. Grades wrong programs as hairgrade does, but only as far as needed: cases and the whole run
// first; pictures only if a program passes all of these.
#pragma once

#include <string>
#include <vector>

#include "grader/compile/compiler.h"
#include "grader/compile/toolchain.h"
#include "grader/grading/suite_jobs.h"
#include "grader/result/result.h"

namespace grader::inline mutants {

enum class Judgement { does_not_compile, loses_points, gets_all };

struct Judged {
  Judgement judgement = Judgement::does_not_compile;
  // Lists categories, also the whole run; empty if they were not counted.
  std::vector<CaseResult> lost = {};
};

class Judging {
 public:
  // `settings.exercise` names the exercise. Throws as Grading does, in grader/grading/grading.h.
  explicit Judging(GradingSettings settings);

  // Judges the file `source` of the submission `name`. Threads may call it in parallel, with different names.
  Judged judge(const std::string& name, const std::string& source) const;

 private:
  std::vector<CaseResult> lost(const std::string& name, const std::filesystem::path& object,
                               const std::filesystem::path& job) const;

  GradingSettings settings_;
  const Exercise& exercise_;
  StagedKit kit_;
  Compiler compiler_;
  SuiteJobs jobs_;
};

}  // namespace grader::mutants
