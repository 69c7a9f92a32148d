// STAFF ONLY. How many submissions a minute are graded, and where the time goes, as Markdown tables.
//
//   grading_bench [SUBMISSIONS]
//
// A batch (8, if not said otherwise) of right submissions, of all exercises, two at a time: first with nothing
// in the cache of compiled objects, then with all of them in it. Then the parts of it, one at a time, of an
// exercise without Eigen and of one with it, beside the plain compiler outside of any cage. Every part is checked
// to have done its work.
#include <signal.h>
#include <sodium.h>
#include <stdlib.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>

#include "grader/bench/cost.h"
#include "grader/judge/student/student.h"
#include "grader/sandbox/system_mounts.h"
#include "grader/tool/batch.h"
#include "grader/tool/grading.h"
#include "grader/tool/suite_run.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"

namespace grader_bench {
namespace {

namespace fs = std::filesystem;
using namespace grader;

constexpr int kJobs = 2, kRounds = 9;
constexpr double kGoal = 60;  // submissions a minute

void require(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error(what);
}

// A right solution, one of those of the sample class, and no two the same bytes.
Submission submission(const Course& course, int number) {
  static const char* const solutions[] = {"plain.cpp", "other-order.cpp", "own-vectors.cpp", "recursion.cpp"};
  Submission result;
  result.name = "submission-" + std::to_string(number);
  for (const Exercise& exercise : course.exercises) {
    fs::path file = fs::path(HAIR_PROJECT) / "reference" / exercise.id / "right" /
                    solutions[static_cast<std::size_t>(number) % std::size(solutions)];
    if (number % 2 == 0 || !fs::exists(file)) file = HAIR_PROJECT / solution_of(exercise);
    result.files[exercise.file].text = hair::bytes_of(file) + "// " + result.name + "\n";
  }
  return result;
}

// One row: a batch without a look for memory errors, or with one.
double time_batch(const Grading& grading, const std::vector<Submission>& submissions, const fs::path& out,
                  const std::string& name) {
  BatchSettings batch;
  batch.out = out;
  batch.jobs = kJobs;
  Batch result;
  const Cost cost =
      cost_of([&] { result = grade_batch(grading, submissions, batch, std::atomic<bool>(false)); });
  require(result.graded == static_cast<int>(submissions.size()), "not all are graded");
  for (const SubmissionResult& one : result.results)
    for (const ExerciseResult& exercise : one.exercises)
      require(exercise.status == Status::passed, one.name + " has not passed " + exercise.id);
  const double count = static_cast<double>(submissions.size());
  std::printf("| %s | %.1f | %.1f | %.2f | %.0f | %.0f |\n", name.c_str(), cost.wall, cost.cpu,
              cost.cpu / count, 60 * count / cost.wall, kJobs * 60 * count / cost.cpu);
  std::fflush(stdout);
  return cost.cpu;
}

void time_batches(const Course& course, const fs::path& scratch, int count) {
  std::vector<Submission> submissions;
  for (int i = 0; i < count; ++i) submissions.push_back(submission(course, i));
  std::printf(
      "| %d submissions, %d at a time | seconds | CPU seconds | of each | a minute | a minute, if all of %d "
      "cores were its own |\n",
      count, kJobs, kJobs);
  std::printf("|---|--:|--:|--:|--:|--:|\n");
  double cold[2] = {}, warm[2] = {};
  for (const bool memory_errors : {false, true}) {
    if (memory_errors && !memory_can_be_bounded()) break;
    GradingSettings settings;
    settings.course = course;
    settings.kit = HAIR_KIT_DIR;
    settings.suite = HAIR_SUITE;
    settings.players = HAIR_PLAYERS;
    settings.scenes = fs::path(HAIR_HIDDEN_SCENES);
    settings.memory_errors = memory_errors;
    const std::string name = memory_errors ? "with a look for memory errors" : "without";
    settings.cache = scratch / ("cache " + name);
    settings.secret = "the secret of the benchmark";
    const Grading grading(settings);
    // Precompiled headers are made once for a kit.
    BatchSettings first;
    first.out = scratch / "first";
    grade_batch(grading, {submission(course, count)}, first, std::atomic<bool>(false));
    cold[memory_errors] = time_batch(grading, submissions, scratch / ("cold " + name), name + ", cold cache");
    warm[memory_errors] = time_batch(grading, submissions, scratch / ("warm " + name), name + ", warm cache");
  }
  std::printf("\nCPU time with the look for memory errors, of that without: %.2f cold, %.2f warm.\n",
              cold[1] / cold[0], warm[1] / warm[0]);
  std::printf("\nThe goal: at least %.0f a minute.\n\n", kGoal);
}

// The parts of grading one exercise.
void time_parts(const Course& course, const Exercise& exercise, const fs::path& scratch) {
  const StagedKit kit(HAIR_KIT_DIR, course);
  const Compiler compiler(kit, scratch / "parts", Isolation::namespaces);
  const std::string id = exercise.id, source = hair::bytes_of(HAIR_PROJECT / solution_of(exercise));
  const std::string file = (scratch / exercise.file).string(), object = (scratch / (id + ".o")).string();
  std::ofstream(file) << source;

  std::vector<std::string> compile = {"/usr/bin/g++",      "-std=c++20", "-O2",      "-fPIC",
                                      "-ffp-contract=off", "-pipe",      "-isystem", "/usr/include/eigen3"};
  const std::string handout = (kit.folder() / "handout").string();
  compile.insert(compile.end(), {"-I" + handout + "/given", "-I" + handout, "-c", file, "-o", object});
  std::vector<std::string> link = {"/usr/bin/g++", "-shared", "-s", "-Wl,-z,defs", "-Wl,-z,now"};
  link.insert(link.end(), {"-Wl,--version-script=" + (kit.folder() / "export" / (id + ".map")).string(), "-o",
                           (scratch / (id + ".so")).string(), object});
  for (const std::string& prerequisite : exercise.prerequisites)
    link.push_back((kit.folder() / "provided" / (prerequisite + ".so")).string());
  const std::vector<fs::path> objects = {kit.folder() / "lib" / (id + ".so")};

  Cage toolchain;
  toolchain.mounts = toolchain_mounts();
  for (const Mount& mount : header_mounts(Isolation::namespaces, kit.empty_folder()))
    toolchain.mounts.push_back(mount);
  toolchain.tmp_bytes = 64 << 20;
  toolchain.syscalls = Syscalls::toolchain;

  int round = 0;
  auto compile_in_cages = [&](const std::string& text) {
    const Compiled compiled = compiler.compile(exercise, text, kit.new_job(id + std::to_string(round++)), 60);
    require(!compiled.object.empty(), exercise.file + " does not compile: " + compiled.log);
  };
  auto start_worker = [&] {
    WorkerSetup setup;
    setup.kit = kit.folder();
    setup.exercise = id;
    setup.provided = exercise.prerequisites;
    setup.objects = objects;
    setup.log = scratch / "log";
    Student student(setup);
    // A request that holds nothing: the server can only say that it makes no sense.
    const Answer answer = student.ask({}, {});
    require(answer.outcome == Outcome::threw, "the worker does not answer: " + answer.note);
    student.finish();
  };
  auto run_cases = [&] {
    SuiteJob job;
    job.exercise = id;
    job.seed = "a seed";
    job.kit = kit.folder();
    job.provided = exercise.prerequisites;
    job.objects = objects;
    job.log = scratch / "log";
    const SuiteResult found = run_suite(HAIR_SUITE, job);
    for (const CaseResult& one : found.cases)
      require(one.status == Status::passed, "the reference fails in " + one.name);
  };
  compile_in_cages(source);

  const std::vector<Part> parts = {
      {"g++ -c", [&] { require(run_program(compile) == 0, "g++ -c fails"); }},
      {"g++ -shared", [&] { require(run_program(link) == 0, "g++ -shared fails"); }},
      {"compile and link, in cages",
       [&] { compile_in_cages(source + "// " + std::to_string(round) + "\n"); }},
      {"the same, cached", [&] { compile_in_cages(source); }},
      {"an empty cage",
       [&] { require(CagedProcess(toolchain, {"/usr/bin/true"}, -1, -1, -1).wait(10).well(), "no cage"); }},
      {"a suite without a job",
       [&] { require(run_program({HAIR_SUITE}) == 2, "the suite takes no job for one"); }},
      {"a worker's start and end", start_worker},
      {"suite, worker and cases", run_cases}};
  const std::vector<Cost> costs = median_costs(parts, kRounds);

  std::printf("| %s | ms | CPU ms | times as long as outside |\n|---|--:|--:|--:|\n", id.c_str());
  const Cost outside = costs[0] + costs[1];
  auto row = [](const std::string& name, const Cost& cost, const std::string& ratio = "") {
    std::printf("| %s | %.0f | %.0f | %s |\n", name.c_str(), 1e3 * cost.wall, 1e3 * cost.cpu, ratio.c_str());
  };
  char ratio[80];
  std::snprintf(ratio, sizeof ratio, "%.2f (CPU %.2f)", costs[2].wall / outside.wall,
                costs[2].cpu / outside.cpu);
  for (std::size_t i = 0; i < parts.size(); ++i) row(parts[i].name, costs[i], i == 2 ? ratio : "");
  row("so the cases alone", costs[7] - costs[6] - costs[5]);
  std::printf("\n");
}

}  // namespace
}  // namespace grader_bench

int main(int argc, char* argv[]) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 8;
  if (argc > 2 || count < 1) {
    std::cerr << "usage: grading_bench [SUBMISSIONS]; a number from 1\n";
    return 2;
  }
  signal(SIGPIPE, SIG_IGN);
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // rows as they are measured, also into a pipe
  try {
    if (sodium_init() < 0) throw std::runtime_error("no source of random numbers");
    const hair::TemporaryFolder scratch("grading-bench");
    const grader::Course course =
        grader::read_course(std::filesystem::path(HAIR_PROJECT) / "handout/exercises.json");
    grader_bench::time_batches(course, scratch.path(), count);
    for (const char* id : {"S1", "H2"}) grader_bench::time_parts(course, *course.find(id), scratch.path());
  } catch (const std::exception& error) {
    std::cerr << "grading_bench: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
