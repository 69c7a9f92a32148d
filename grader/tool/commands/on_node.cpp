// STAFF ONLY. A task of `hairgrade grade --slurm`: asks its node for all that grading needs, and grades its
// share of the plan. It opens no record.
#include <functional>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "grader/compile/hash.h"
#include "grader/course/input.h"
#include "grader/record/points/hand_ins.h"
#include "grader/sandbox/processes/identity.h"
#include "grader/sandbox/system_mounts.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/grade_options.h"
#include "hair/io/files/read_file.h"
#include "solver/timing.h"

namespace grader::inline tool {
namespace {

namespace fs = std::filesystem;

struct NodeLacks : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Node {
  std::unique_ptr<Grading> grading;
  std::string common;  // FirstTask's
  double seconds = 0;
  std::function<void()> try_again;  // throws NodeLacks
};

// Grades the reference's files as a hand-in: it needs compiler, sandbox, suite and pictures.
void grade_reference_files(const Grading& grading, const GradingSettings& settings, bool all,
                           const std::string& node) {
  Submission reference{.name = "reference", .origin = "reference"};
  for (const Exercise& exercise : settings.course.exercises) {
    if (!settings.course.asks_for(exercise) || (settings.exercise && *settings.exercise != exercise.id))
      continue;
    // Another text is compiled, and not taken from the cache.
    reference.files[exercise.file].text =
        hair::bytes_of(settings.reference / exercise.id / exercise.file) + "// on " + node + "\n";
    if (!all) break;
  }
  const Graded graded = grading.grade(reference);
  if (!graded.problems.empty()) throw BadInput(graded.problems.front());
  for (const ExerciseResult& one : graded.result.exercises)
    if (reference.files.contains(one.file) && one.status != Status::passed)
      throw BadInput("the reference's " + one.file + ": " + to_string(one.status) + "; " +
                     printable(one.feedback + " " + one.staff_log, 600));
}

// Throws std::exception with the part that this node lacks.
Node ready(GradeSettings options, const SharedPlan& plan, const std::string& node, const fs::path& cache) {
  plan.try_it(node);
  const MadeBy there = made_by_from_json(plan.get<PlanFacts>("plan").made_by).value();
  options.secret = plan / "secret";
  options.cache = cache;
  options.isolation = there.isolation;
  const GradingSettings settings = settings_of(options);
  for (const Difference& one : differences(there, made_by(settings)))
    throw BadInput("it would grade with " + one.what + " (\"there\" is the machine that sent the tasks)");
  std::optional<FirstTask> first;
  if (plan.has("first")) first = plan.get<FirstTask>("first");
  Node made_ready;
  made_ready.grading =
      std::make_unique<Grading>(settings, first ? std::optional(first->reference) : std::nullopt);
  made_ready.common = sha256(made_ready.grading->fingerprint({}) + sha256_of(system_compiler()));
  if (first && first->common != made_ready.common)
    throw BadInput("its compiler, suite or renderer is another one than the first task's node has");
  const timing::Stopwatch grading;
  grade_reference_files(*made_ready.grading, settings, !first, node);
  made_ready.seconds = grading.seconds();
  made_ready.try_again = [settings, node, &there = *made_ready.grading, times = 0]() mutable {
    try {
      grade_reference_files(there, settings, false, node + ", " + std::to_string(++times));
    } catch (const std::exception& lacks) {
      throw NodeLacks(lacks.what());
    }
  };
  return made_ready;
}

// Throws NodeLacks if the node could not grade, and leaves that hand-in to others.
int grade_share(const Node& node, const SharedPlan& plan, const std::vector<std::size_t>& hand_ins) {
  const std::atomic<bool>& interrupted = note_interruptions();
  const auto try_after = [&](const Graded& graded) {
    try {
      if (!graded.problems.empty()) node.try_again();
    } catch (const NodeLacks&) {
      if (!interrupted) throw;
    }
  };
  std::vector<std::pair<std::size_t, Graded>> ended_by_the_clock;
  for (const std::size_t number : hand_ins) {
    if (interrupted) return kInterrupted;
    const auto submission = plan.get<Submission>(numbered("hand-ins", number));
    std::cerr << "hairgrade: began " << number << ", " << submission.name << "\n";
    Graded graded = node.grading->grade(submission);
    if (interrupted) return kInterrupted;
    try_after(graded);
    if (interrupted) return kInterrupted;
    if (graded.result.ended_by_the_clock.empty())
      plan.put_result(number, node.grading->fingerprint(submission), graded);
    else
      ended_by_the_clock.emplace_back(number, std::move(graded));
  }
  for (auto& [number, graded] : ended_by_the_clock) {
    const Submission submission = plan.get<Submission>(numbered("hand-ins", number));
    node.grading->grade_again(submission, graded);
    if (interrupted) return kInterrupted;
    try_after(graded);
    if (interrupted) return kInterrupted;
    plan.put_result(number, node.grading->fingerprint(submission), graded);
  }
  return 0;
}

}  // namespace

int do_step(GradeOptions options) {
  const std::vector<std::string>& step = options.slurm.step;
  if (step.front() == "collect" || step.front() == "last") return collect(std::move(options));
  const SharedPlan plan(step.at(1));
  const std::string node = options.slurm.node.empty() ? "this node" : options.slurm.node;
  const bool is_first = step.front() == "first";
  std::vector<std::size_t> hand_ins;
  if (!is_first) {
    hand_ins = plan.get<SentArray>("arrays/" + step.at(2)).hand_ins.at(std::stoul(step.at(3)));
    // The task may run again.
    std::erase_if(hand_ins, [&](std::size_t one) { return plan.has(numbered("results", one)); });
    if (hand_ins.empty()) return 0;
  }

  // Objects of students stay on the node, for many nodes would look through a large shared folder.
  const StagingFolder own;
  const fs::path cache = is_first ? plan / "cache" : own.path() / "cache";
  Node made_ready;
  const auto refuse = [&](const std::exception& lacks) {
    std::cerr << "hairgrade: " << node << ": " << lacks.what() << "\n";
    if (!is_first) plan.write("refused/" + node, "");
    return 3;
  };
  try {
    if (!is_first) {
      fs::create_directory(cache);
      for (const fs::directory_entry& kept : fs::directory_iterator(plan / "cache"))
        fs::create_symlink(kept.path(), cache / kept.path().filename());
    }
    GradeSettings settings = options.settings;
    if (settings.course) settings.course = plan / "course.json";
    const Course course = read_course(HAIR_EXERCISES_JSON, settings.course);
    settings.of_hand_in = read_hand_in(course, settings.course, options.batch.hand_in).rules.exercises;
    made_ready = ready(settings, plan, node, cache);
  } catch (const std::exception& lacks) {
    return refuse(lacks);
  }
  if (is_first) {
    plan.put("first", FirstTask{made_ready.grading->reference(), made_ready.common, made_ready.seconds});
    return 0;
  }
  try {
    return grade_share(made_ready, plan, hand_ins);
  } catch (const NodeLacks& lacks) {
    return refuse(lacks);
  }
}

}  // namespace grader::tool
