// STAFF ONLY. The hidden suite of one exercise, as a GoogleTest program: links the reference, and never a
// student's code.
//
// Reads a job as JSON from standard input and writes what it found as JSON to standard output:
//
//   {"exercise": "S2", "seed": "...", "kit": DIR, "provided": ["S1"], "objects": [FILE...], "log": FILE,
//    "isolated": true, "cpu_seconds": 10, "allowance": {"idle_seconds": 3, ...}, "pictures": DIR, "sanitised": FILE}
//   {"cases": [{"name", "status", "weight", "points", "feedback", "detail", "cases", "held"}...],
//    "cpu_seconds": 0.1, "starts": 1, "spent": {"idle_seconds": 0.01, ...}}
//
// "provided" are the exercises whose functions the suite provides (provided.h). "allowance" and "spent" are as in grader/course/budget.h.
// "sanitised" is the student's object with sanitizers, or "" if there is none; without it memory errors are not looked
// for, and the result has no "memory": {"told": a sentence or "", "offsets": [...], "cpu_seconds": 0.1}, which is told to
// the student, and where in the object it is (grader/wire/memory_error.h).
// "pictures" is where the reference's are kept; null, and none are drawn. Of an exercise with a whole run the job says
// more, and its two categories come last, with its pictures:
//
//   {..., "whole_run": {"scene": FILE, "seed": "...", "player": FILE, "cpu_seconds": 10}}
//   {..., "pictures": [{"name", "blurred_rmse", "flip", "student", "reference", "heat"}...],
//    "run_cpu_seconds": 0.1, "picture_cpu_seconds": 0.1}
//
// Of the exercise "runs", which stands for all of them end to end, the job says more, and another result comes out:
//
//   {..., "left_out": ["P2"...], "unavailable": {"H4": "does not compile"...}}
//   {"runs": [{"name", "shows", "outcome", "feedback", "detail", "pictures"}...], "cpu_seconds": 0.1, "starts": 1}
//
// The exercise "study" is "runs" once more, beside a worker with other objects, the reference's; "motions" is where what
// is true of a scene is kept:
//
//   {..., "left_out": [...], "unavailable": {...}, "reference_objects": [FILE...], "motions": DIR}
//   {"study": STUDY, "cpu_seconds": 0.1, "starts": 1}                                   see grader/result/study_json.h
#include <gtest/gtest.h>
#include <signal.h>
#include <sodium.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "grader/course/input.h"
#include "grader/result/base64.h"
#include "grader/result/study_json.h"
#include "grader/suite/end_to_end.h"
#include "grader/suite/memory_errors.h"
#include "grader/suite/study/submission_study.h"
#include "grader/suite/suite_table.h"
#include "grader/suite/trial.h"
#include "grader/suite/whole_run.h"

namespace {

using grader::Category;
using nlohmann::json;

struct Job {
  std::string exercise, seed;
  grader::WorkerSetup worker;
  grader::AvailableExercises exercises;  // for runs and studies
  std::vector<std::filesystem::path> reference_objects;
  std::filesystem::path motions;
  std::optional<std::filesystem::path> pictures, sanitised;
  bool count_cases = true;

  struct WholeRun {
    std::filesystem::path scene;
    std::string seed;
    std::filesystem::path player;
    int cpu_seconds = 10;
  };
  std::optional<WholeRun> whole_run;
};

Job read_job(std::istream& in) {
  try {
    const json document = json::parse(in);
    Job job;
    job.exercise = document.at("exercise");
    job.seed = document.at("seed");
    job.worker.exercise = job.exercise;
    job.worker.kit = document.at("kit").get<std::string>();
    document.at("provided").get_to(job.worker.provided);
    for (const std::string object : document.at("objects")) job.worker.objects.push_back(object);
    job.worker.log = document.at("log").get<std::string>();
    job.worker.isolated = document.at("isolated");
    job.worker.cpu_seconds = document.at("cpu_seconds");
    job.count_cases = document.at("count_cases");
    for (const grader::BudgetField& field : grader::budget_fields())
      job.worker.allowance->limit.*field.value = document.at("allowance").at(field.key);
    if (const json& folder = document.at("pictures"); !folder.is_null())
      job.pictures = folder.get<std::string>();
    if (document.contains("sanitised")) job.sanitised = document.at("sanitised").get<std::string>();
    if (document.contains("whole_run")) {
      const json& run = document.at("whole_run");
      job.whole_run = {run.at("scene").get<std::string>(), run.at("seed"),
                       run.at("player").get<std::string>(), run.at("cpu_seconds")};
    }
    if (job.exercise == "study") {
      job.worker.exercise = "runs";
      job.worker.cpu_seconds = grader::study_cpu_seconds();
      // Asked for by the instructor, beside the submission's budget.
      grader::Budget& limit = job.worker.allowance->limit;
      limit.worker_cpu_seconds = limit.suite_cpu_seconds = job.worker.cpu_seconds;
      for (const std::string object : document.at("reference_objects"))
        job.reference_objects.push_back(object);
      job.motions = document.at("motions").get<std::string>();
    }
    if (job.worker.exercise == "runs") {
      document.at("left_out").get_to(job.exercises.left_out);
      document.at("unavailable").get_to(job.exercises.unavailable);
    }
    return job;
  } catch (const json::exception& error) {
    throw grader::BadInput(std::string("standard input: ") + error.what() +
                           "; expected a job as hairgrade writes it");
  }
}

// One category as a GoogleTest test.
class CategoryTest : public testing::Test {
 public:
  CategoryTest(const Category& category, grader::Student& student, const std::string& seed,
               grader::Recording& recording, json& cases)
      : category_(category), student_(student), seed_(seed), recording_(recording), cases_(cases) {}

  void TestBody() override {
    json result = {{"name", category_.title},
                   {"weight", category_.weight},
                   {"points", 0},
                   {"status", "passed"},
                   {"feedback", ""},
                   {"detail", ""},
                   {"cases", 0},
                   {"held", 0}};
    recording_.begin_category(category_.title);
    try {
      grader::Trial trial(student_, grader::Random(seed_, category_.name));
      category_.run(trial);
      result["points"] = category_.weight;
    } catch (const grader::CaseFailed& failure) {
      result["status"] = grader::to_string(failure.status);
      result["feedback"] = failure.feedback;
      result["detail"] = failure.detail;
      ADD_FAILURE() << failure.feedback << "\n" << failure.detail;
    } catch (const grader::MalformedMessage& error) {
      result["status"] = grader::to_string(grader::Status::broke_rules);
      result["feedback"] = "the code answered in a form that it has no business with";
      result["detail"] = error.what();
      ADD_FAILURE() << error.what();
    } catch (const std::exception& error) {  // ours: there is no result without this category
      std::cerr << "hairsuite: " << category_.name << ": " << error.what() << "\n";
      return;
    }
    cases_.push_back(result);
  }

 private:
  const Category& category_;
  grader::Student& student_;
  const std::string& seed_;
  grader::Recording& recording_;
  json& cases_;
};

json to_json(const std::vector<grader::PictureResult>& pictures) {
  json all = json::array();
  for (const grader::PictureResult& picture : pictures)
    all.push_back({{"name", picture.name},
                   {"blurred_rmse", picture.blurred_rmse},
                   {"flip", picture.flip},
                   {"far_off", picture.far_off},
                   {"student", grader::base64(picture.student)},
                   {"reference", grader::base64(picture.reference)},
                   {"heat", grader::base64(picture.heat)}});
  return all;
}

// Of each wrong category, how many of its cases hold. It comes last: what it takes of the budget nothing else lacks.
void count_cases(const std::vector<Category>& categories, grader::Student& student, const std::string& seed,
                 json& cases) {
  student.record(nullptr);
  for (std::size_t i = 0; i < categories.size() && !student.gave_up(); ++i) {
    if (cases[i].at("status") != grader::to_string(grader::Status::wrong)) continue;
    const std::optional<grader::CaseCount> count =
        count_of(categories[i], student, grader::Random(seed, categories[i].name));
    if (!count) continue;
    cases[i]["cases"] = count->cases;
    cases[i]["held"] = count->held;
  }
}

// Null if a category has no result, which is our fault.
json run_categories(const Job& job, grader::Student& student) {
  std::vector<Category> categories = grader::categories(job.exercise), of_the_run, of_memory;
  json cases = json::array();
  grader::Recording recording;
  std::optional<grader::WholeRun> run;
  if (job.whole_run) {
    grader::HiddenScene scene = grader::read_hidden_scene(job.whole_run->scene, job.whole_run->seed);
    grader::WorkerSetup worker = job.worker;
    worker.cpu_seconds = job.whole_run->cpu_seconds;
    run.emplace(std::move(worker), job.whole_run->player, std::move(scene), job.pictures, student);
    of_the_run = run->categories(job.exercise);
  }
  std::optional<grader::MemoryErrors> memory;
  if (job.sanitised) {
    student.record(&recording);
    std::vector<grader::Student*> earlier = {&student};
    if (run) earlier.push_back(&run->student());
    memory.emplace(job.worker, *job.sanitised, std::move(earlier), recording, [&cases] {
      return std::any_of(cases.begin(), cases.end(),
                         [](const json& one) { return one.at("status") == "passed"; });
    });
    of_memory.push_back(memory->category());
    grader::pay_for_memory_errors(categories, of_the_run);
  }

  auto add = [&](const Category& category, grader::Student& who) {
    testing::RegisterTest(
        job.exercise.c_str(), category.name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
        [&]() -> testing::Test* { return new CategoryTest(category, who, job.seed, recording, cases); });
  };
  for (const Category& category : categories) add(category, student);
  for (const Category& category : of_the_run) add(category, run->student());
  for (const Category& category : of_memory) add(category, memory->student());

  // Standard output carries the result, and nothing else.
  testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
  delete listeners.Release(listeners.default_result_printer());
  const bool ran = RUN_ALL_TESTS() >= 0;  // a category that fails is a result, not an error
  if (!ran || cases.size() != categories.size() + of_the_run.size() + of_memory.size()) return {};
  if (job.count_cases) count_cases(categories, student, job.seed, cases);
  json result = {{"cases", cases}, {"allocations", student.allocations()}};
  if (run) {
    run->student().finish();
    result["pictures"] = to_json(run->pictures());
    result["run_cpu_seconds"] = run->student().cpu_seconds();
    result["picture_cpu_seconds"] = run->picture_seconds();
  }
  if (memory)
    result["memory"] = {{"told", memory->told()},
                        {"offsets", memory->offsets()},
                        {"cpu_seconds", memory->student().cpu_seconds()}};
  return result;
}

json run_scenes(const Job& job, grader::Student& student) {
  json runs = json::array();
  for (const grader::RunResult& run : grader::run_end_to_end(student, job.exercises, job.pictures))
    runs.push_back({{"name", run.name},
                    {"shows", run.shows},
                    {"outcome", grader::to_string(run.outcome)},
                    {"feedback", run.feedback},
                    {"detail", run.detail},
                    {"pictures", to_json(run.pictures)}});
  return {{"runs", runs}};
}

json study(const Job& job, grader::Student& student) {
  grader::WorkerSetup setup = job.worker;
  setup.objects = job.reference_objects;
  setup.allowance = std::make_shared<grader::Allowance>(grader::Allowance{job.worker.allowance->limit});
  grader::Student reference(setup);
  return {{"study", json::parse(grader::study_json(
                        grader::study_submission(student, reference, job.exercises, job.motions)))}};
}

// What a job's result holds beside the worker's CPU time; null if a category has none.
json run(const Job& job, grader::Student& student) {
  if (job.exercise == "runs") return run_scenes(job, student);
  if (job.exercise == "study") return study(job, student);
  return run_categories(job, student);
}

}  // namespace

// In a build with sanitisers: looking for leaks when the process ends fails now and then beside OSMesa's threads, and a
// submission would have no result. The suite's own tests look for leaks in the same code.
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming): the sanitiser's name
extern "C" int __lsan_is_turned_off() {
  return 1;
}

int main(int argc, char* argv[]) {
  // Ends with hairgrade, whatever ends that, and its worker with it.
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  signal(SIGPIPE, SIG_IGN);
  for (int ending : {SIGINT, SIGTERM, SIGHUP}) signal(ending, [](int number) { _exit(128 + number); });
  testing::InitGoogleTest(&argc, argv);
  if (sodium_init() < 0) return 1;
  try {
    const Job job = read_job(std::cin);
    grader::Student student(job.worker);
    json result = run(job, student);
    student.finish();
    const bool whole = !result.is_null();
    result["cpu_seconds"] = student.cpu_seconds();
    result["starts"] = student.starts();
    for (const grader::BudgetField& field : grader::budget_fields())
      result["spent"][field.key] = job.worker.allowance->spent.*field.value;
    std::cout << result.dump(-1, ' ', false, json::error_handler_t::replace) << std::endl;
    return whole ? 0 : 1;
  } catch (const grader::BadInput& error) {
    std::cerr << "hairsuite: " << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "hairsuite: " << error.what() << "\n";
    return 1;
  }
}
