// STAFF ONLY. Runs the hidden suite of one exercise as a GoogleTest program: it links the reference, and
// never a student's code. An exercise's whole run comes after its cases.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "grader/judge/cases/suite_table.h"
#include "grader/judge/cases/trial.h"
#include "grader/judge/reproduction.h"
#include "grader/judge/run/whole_run.h"
#include "grader/judge/suite_program.h"
#include "grader/sandbox/inherited.h"

namespace {

using grader::CaseResult, grader::Category, grader::Status, grader::SuiteJob, grader::SuiteResult;

// Runs one category as a GoogleTest test.
class CategoryTest : public testing::Test {
 public:
  CategoryTest(const Category& category, grader::Student& student, const std::string& seed,
               std::vector<CaseResult>& cases)
      : category_(category), student_(student), seed_(seed), cases_(cases) {}

  void TestBody() override {
    CaseResult result;
    result.name = category_.title;
    result.status = Status::passed;
    result.max_points = category_.weight;
    try {
      grader::Trial trial(student_, grader::Random(seed_, category_.name));
      category_.run(trial);
      result.points = category_.weight;
    } catch (const grader::CaseFailed& failure) {
      result.status = failure.status;
      result.feedback = failure.feedback;
      result.detail = failure.detail;
      result.hint = failure.hint;
      result.error_in_limits = failure.error_in_limits;
      ADD_FAILURE() << failure.feedback << "\n" << failure.detail;
    } catch (const grader::MalformedMessage& error) {
      result.status = Status::broke_rules;
      result.feedback = "the code sent the grader a message that does not fit the request";
      result.detail = error.what();
      ADD_FAILURE() << error.what();
    } catch (const std::exception& error) {  // our own error: this category has no result
      std::cerr << "hairsuite: " << category_.name << ": " << error.what() << "\n";
      return;
    }
    cases_.push_back(std::move(result));
  }

 private:
  const Category& category_;
  grader::Student& student_;
  const std::string& seed_;
  std::vector<CaseResult>& cases_;
};

// Counts the cases that hold in each wrong category. It comes last, so that it takes budget from nothing
// else.
void count_cases(const std::vector<Category>& categories, grader::Student& student, const std::string& seed,
                 std::vector<CaseResult>& cases) {
  for (std::size_t i = 0; i < categories.size() && !student.gave_up(); ++i) {
    if (cases[i].status != Status::wrong) continue;
    const std::optional<grader::CaseCount> count =
        count_of(categories[i], student, grader::Random(seed, categories[i].name));
    if (!count) continue;
    cases[i].cases = count->cases;
    cases[i].held = count->held;
  }
}

SuiteResult run_categories(const SuiteJob& job, const grader::WorkerSetup& setup, grader::Student& student) {
  std::vector<Category> categories = grader::categories(job.exercise), of_the_run;
  SuiteResult result;
  std::vector<CaseResult>& cases = result.cases;
  std::optional<grader::WholeRun> run;
  if (job.whole_run) {
    grader::HiddenScene scene = grader::read_hidden_scene(job.whole_run->scene, job.whole_run->seed);
    grader::WorkerSetup worker = setup;
    worker.cpu_seconds = job.whole_run->cpu_seconds;
    run.emplace(std::move(worker), job.whole_run->runner, std::move(scene), job.pictures, student);
    of_the_run.push_back(run->category(job.exercise));
  }

  auto add = [&](const Category& category, grader::Student& who) {
    testing::RegisterTest(
        job.exercise.c_str(), category.name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
        [&]() -> testing::Test* { return new CategoryTest(category, who, job.seed, cases); });
  };
  for (const Category& category : categories) add(category, student);
  for (const Category& category : of_the_run) add(category, run->student());

  // Standard output carries the result alone.
  testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
  delete listeners.Release(listeners.default_result_printer());
  const bool ran = RUN_ALL_TESTS() >= 0;  // a failed category is a result, not an error
  if (!ran || cases.size() != categories.size() + of_the_run.size())
    throw std::runtime_error("a category has no result");
  count_cases(categories, student, job.seed, cases);
  if (run) {
    run->student().finish();
    result.pictures = run->pictures();
    result.motions = run->motions();
    result.run_cpu_seconds = run->student().cpu_seconds();
    result.picture_cpu_seconds = run->picture_seconds();
  }
  return result;
}

SuiteResult run(const SuiteJob& job) {
  const grader::WorkerSetup worker = grader::worker_of(job);
  grader::Student student(worker);
  SuiteResult result;
  if (job.reproduce.empty())
    result = run_categories(job, worker, student);
  else
    result.reproduced = grader::reproduce(job, student);
  add_costs(student, worker, result);
  return result;
}

}  // namespace

int main(int argc, char* argv[]) {
  grader::set_what_is_inherited(argv);
  testing::InitGoogleTest(&argc, argv);
  return grader::run_suite_program("hairsuite", run);
}
