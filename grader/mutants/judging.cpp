// STAFF ONLY. Grades a wrong program as far as needed.
#include "grader/mutants/judging.h"

#include <stdexcept>
#include <utility>

#include "grader/grading/exercise_grading.h"

namespace grader::inline mutants {
namespace {

namespace fs = std::filesystem;

const Exercise& exercise_of(const GradingSettings& settings) {
  const Exercise* exercise = settings.exercise ? settings.course.find(*settings.exercise) : nullptr;
  if (exercise == nullptr) throw std::invalid_argument("the settings must name an exercise");
  return *exercise;
}

}  // namespace

Judging::Judging(GradingSettings settings)
    : settings_(std::move(settings)),
      exercise_(exercise_of(settings_)),
      kit_(settings_.kit, settings_.course),
      compiler_(kit_, settings_.cache, settings_.isolation),
      jobs_(settings_, kit_) {
  jobs_.limit_by(grade_reference(jobs_, compiler_));
}

Judged Judging::judge(const std::string& name, const std::string& source) const {
  const fs::path job = kit_.new_job(name);
  const double seconds = settings_.course.budget.compiler_cpu_seconds;
  const Compiled compiled = compiler_.compile(exercise_, source, job, seconds);
  if (compiled.object.empty()) return {Judgement::does_not_compile};
  if (std::vector<CaseResult> categories = lost(name, compiled.object, job); !categories.empty())
    return {Judgement::loses_points, std::move(categories)};

  Submission submission;
  submission.name = name;
  submission.files[exercise_.file].text = source;
  ExerciseResult result = describe(exercise_);
  ExerciseTiming timing;
  grade_exercise(jobs_, compiler_, exercise_, submission, kit_.new_job(name + "-all"), seconds, result,
                 timing);
  return {result.status == Status::passed ? Judgement::gets_all : Judgement::loses_points};
}

std::vector<CaseResult> Judging::lost(const std::string& name, const fs::path& object,
                                      const fs::path& job) const {
  SuiteJob cases = jobs_.cases(exercise_, name, object, job);
  cases.pictures.reset();
  ExerciseTiming timing;
  SuiteResult found = jobs_.run(cases, timing);
  std::erase_if(found.cases, [](const CaseResult& one) { return one.status == Status::passed; });
  return std::move(found.cases);
}

}  // namespace grader::mutants
