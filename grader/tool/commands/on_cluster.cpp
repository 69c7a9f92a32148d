// STAFF ONLY. `hairgrade grade --slurm` and `hairgrade collect`, on the machine that has the record.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <mutex>
#include <set>

#include "grader/class_folder/folder_of_grades.h"
#include "grader/class_folder/slurm.h"
#include "grader/course/input.h"
#include "grader/grading/secret.h"
#include "grader/record/points/hand_ins.h"
#include "grader/text/shell_word.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/grade_options.h"
#include "grader/tool/commands/of_a_record.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/start_program.h"

namespace grader::inline tool {
namespace {

namespace fs = std::filesystem;

constexpr double kSecondsOfATask = 600;
constexpr double kSpare = 3;  // a hand-in takes this many times a right one's time, on average
constexpr std::size_t kFewestMinutes = 30, kMergedInAMinute = 50;  // give the last job ten times its time

double now() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

std::string last_line(const fs::path& file) {
  std::istringstream lines(hair::bytes_of(file));
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) last = line;
  return printable(last.starts_with("hairgrade: ") ? last.substr(11) : last, 1000);
}

class Sender {
 public:
  Sender(const SharedPlan& plan, const GradeOptions& options)
      : plan_(plan), facts_(plan.get<PlanFacts>("plan")), options_(options) {}

  // Throws BadInput with the node and the part that it lacks. False: interrupted.
  bool try_a_node(const std::atomic<bool>& interrupted) const {
    std::cout << "a first task asks a node for all that grading needs, and times the reference\n"
              << std::flush;
    const fs::path log = plan_ / "logs/first";
    const SentJob job =
        sbatch({"--wait", "--time=30", "--output=" + log.string(), "--chdir=" + facts_.folder.string()},
               options_.slurm.sbatch, command(true, "first"));
    if (interrupted) {
      scancel(job.number);
      return false;
    }
    if (!job.failed && plan_.has("first")) return true;
    const TaskState state = tasks_of(job.number)[0];
    const std::string why = last_line(log);
    throw BadInput("the first task ended on " + (state.node.empty() ? "a node" : state.node) + " (" +
                   state.state + ") and nothing was sent: " +
                   (why.empty() ? "it wrote nothing; can the node see " + (plan_ / "").string() + "?" : why));
  }

  void send(const std::vector<std::size_t>& hand_ins) const {
    const double seconds = std::max(0.1, plan_.get<FirstTask>("first").seconds);
    const std::size_t per_task =
        options_.slurm.per_task > 0
            ? options_.slurm.per_task
            : std::max<std::size_t>(1, static_cast<std::size_t>(kSecondsOfATask / seconds));
    const Budget budget = read_course(HAIR_EXERCISES_JSON, options_.settings.course).budget;
    // A task that is sent again has its first hand-in's whole budget, so that each round gets on.
    const double most = kSpare * static_cast<double>(per_task) * seconds + budget.worker_cpu_seconds +
                        budget.compiler_cpu_seconds + budget.suite_cpu_seconds + budget.idle_seconds;
    const std::string minutes = std::to_string(std::lround(std::ceil(most / 60))), time = "--time=" + minutes,
                      folder = "--chdir=" + facts_.folder.string();
    const std::size_t most_tasks = max_array_size();
    std::string jobs;
    std::size_t tasks = 0, number = plan_.arrays().size();
    for (std::size_t at = 0; at < hand_ins.size(); ++number) {
      SentArray array{.without = plan_.nodes_that_refused()};
      for (; at < hand_ins.size() && array.hand_ins.size() < most_tasks; at += per_task)
        array.hand_ins.emplace_back(
            hand_ins.begin() + static_cast<std::ptrdiff_t>(at),
            hand_ins.begin() + static_cast<std::ptrdiff_t>(std::min(at + per_task, hand_ins.size())));
      plan_.put(numbered("arrays", number), array);
      const std::string log = (plan_ / ("logs/" + std::to_string(number))).string();
      std::vector<std::string> words = {"--array=0-" + std::to_string(array.hand_ins.size() - 1), time,
                                        folder, "--output=" + log + "-%a"};
      if (!array.without.empty()) words.push_back("--exclude=" + array.without);
      array.job = sent(words, command(true, "share", std::to_string(number) + " \"$SLURM_ARRAY_TASK_ID\""));
      plan_.put(numbered("arrays", number), array);
      jobs += ":" + array.job;
      tasks += array.hand_ins.size();
    }
    const std::string last =
        sent({"--dependency=afterany" + jobs,
              "--time=" + std::to_string(kFewestMinutes + facts_.hand_ins / kMergedInAMinute), folder,
              "--output=" + (fs::absolute(options_.batch.out) / kCollectLog).string()},
             command(false, "last"));
    std::cout << hand_ins.size() << " hand-ins in " << tasks << " tasks of " << per_task << ", each at most "
              << minutes << " minutes, jobs " << jobs.substr(1) << "; " << last
              << " collects them, and writes " << (options_.batch.out / kCollectLog).string() << "\n";
  }

 private:
  // Jobs that were sent before go on.
  std::string sent(const std::vector<std::string>& words, const std::string& line) const {
    try {
      return sbatch(words, options_.slurm.sbatch, line).number;
    } catch (const BadInput& refused) {
      throw BadInput(std::string(refused.what()) + "; once it does, hairgrade collect " +
                     shell_word(options_.batch.out.string()) + " takes what is graded, and sends the rest");
    }
  }

  // Returns the line of a shell that does a step. The machine that collects may send again, and needs the
  // environment that Slurm's programs have.
  std::string command(bool on_node, const std::string& step, const std::string& numbers = "") const {
    std::string line = "exec " + options_.slurm.prefix;
    for (const std::string& word : facts_.words)
      if (!on_node || word != "--slurm") line += " " + shell_word(word);
    return line + " --node \"$SLURMD_NODENAME\" --slurm-step " + step + " " +
           shell_word((plan_ / "").string()) + " " + numbers;
  }

  const SharedPlan& plan_;
  PlanFacts facts_;
  const GradeOptions& options_;
};

std::vector<std::string> own_words() {
  std::vector<std::string> words;
  std::ifstream in("/proc/self/cmdline");
  for (std::string word; std::getline(in, word, '\0');) words.push_back(word);
  words.front() = fs::read_symlink("/proc/self/exe").string();
  return words;
}

// Prints a line for each task that ended without all of its results. Returns hand-ins that nobody grades.
std::vector<std::size_t> say_missing(const SharedPlan& plan, const std::vector<std::size_t>& missing) {
  const std::vector<SentArray> arrays = plan.arrays();
  std::set<std::size_t> open(missing.begin(), missing.end()), nobody = open;
  for (std::size_t a = arrays.size(); a-- > 0;) {  // one that was sent again belongs to its last task
    if (arrays[a].job.empty()) continue;
    std::map<std::size_t, TaskState> states = tasks_of(arrays[a].job);
    for (std::size_t k = 0; k < arrays[a].hand_ins.size(); ++k) {
      const TaskState& state = states[k];
      std::size_t left = 0;
      for (const std::size_t one : arrays[a].hand_ins[k]) {
        left += open.erase(one);
        if (state.is_under_way()) nobody.erase(one);
      }
      if (left == 0 || state.is_under_way()) continue;
      const std::string why = last_line(plan / (numbered("logs", a) + "-" + std::to_string(k)));
      std::cerr << "hairgrade: task " << arrays[a].job << "_" << k
                << (state.node.empty() ? "" : " on " + state.node)
                << (state.state.empty() ? "" : " (" + state.state + ")") << " has not graded " << left << ": "
                << (why.empty() ? "it wrote nothing" : why) << "\n";
    }
  }
  if (nobody.size() < missing.size())
    std::cerr << "hairgrade: tasks are at work on " << missing.size() - nobody.size() << " hand-ins\n";
  return {nobody.begin(), nobody.end()};
}

}  // namespace

int hand_over(const GradeOptions& options, const Plan& plan, const GradingSettings& settings, Record& record,
              const std::atomic<bool>& interrupted) {
  PlanFacts facts{.words = own_words(),
                  .folder = fs::current_path(),
                  .made_by = to_json(made_by(settings)),
                  .only = plan.only,
                  .hand_ins = plan.submissions.size(),
                  .began = now()};
  const std::map<std::string, Record::Row> rows = record.rows();
  for (std::size_t i = 0; i < plan.submissions.size(); ++i) {
    const Submission& one = plan.submissions[i];
    if (plan.only && *plan.only != one.name) continue;
    // The folder of grades has one course, suite and secret: the same files have the same result.
    const auto row = rows.find(one.name);
    const bool may_stay = options.batch.resume && !options.batch.regrade && !options.settings.exercise &&
                          row != rows.end() && row->second.origin == one.origin &&
                          row->second.files == hash_of_files(one);
    const std::optional<Recorded> earlier = may_stay ? record.find(one.name) : std::nullopt;
    if (!earlier || earlier->result.fingerprint.empty() ||
        (options.settings.study && !earlier->result.studied))
      facts.asked.push_back(i);
  }
  if (facts.asked.empty()) {
    const auto fingerprint = [&](const Submission& one) {
      return record.find(one.name).value().result.fingerprint;
    };
    const Grader keeps{settings.course,
                       record.costs().reference,
                       facts.made_by,
                       false,
                       fingerprint,
                       [](const Submission&) -> std::optional<Graded> { return {}; },
                       {}};
    return say_graded(settings.isolation, options, plan,
                      grade_batch(keeps, plan, options.batch, record, interrupted), record);
  }
  const SharedPlan shared = SharedPlan::make(options.batch.out);
  try {
    if (options.settings.course) fs::copy_file(*options.settings.course, shared / "course.json");
    keep_secret(settings.secret, shared / "secret");
    for (std::size_t i = 0; i < plan.submissions.size(); ++i)
      shared.put(numbered("hand-ins", i), plan.submissions[i]);
    shared.put("plan", facts);
    record.set_listed(plan.listed);
    if (!Sender(shared, options).try_a_node(interrupted)) {
      std::cerr << "hairgrade: interrupted; nothing was sent\n";
      shared.remove();
      return kInterrupted;
    }
  } catch (...) {
    shared.remove();
    throw;
  }
  Sender(shared, options).send(facts.asked);
  for (const auto* lines : {&plan.remarks, &plan.notices})
    for (const std::string& line : *lines) std::cerr << "hairgrade: " << line << "\n";
  return plan.notices.empty() ? 0 : 3;
}

int collect(GradeOptions options) {
  const SharedPlan shared(options.slurm.step.at(1));
  const auto facts = shared.get<PlanFacts>("plan");
  const std::optional<MadeBy> made_by = made_by_from_json(facts.made_by);
  BatchSettings& settings = options.batch;
  if (options.settings.course) options.settings.course = shared / "course.json";
  const Course course = read_course(HAIR_EXERCISES_JSON, options.settings.course);
  settings.rules = read_hand_in(course, options.settings.course, settings.hand_in).rules;
  settings.merge = options.settings.exercise.has_value();
  settings.resume = true;  // an earlier collect may have put them into the record
  settings.seconds_before = now() - facts.began;
  const std::atomic<bool>& interrupted = note_interruptions();
  std::optional<FolderOfGrades> folder = FolderOfGrades::open(settings.out, made_by.value(), interrupted,
                                                              std::cerr, settings.hand_in, settings.regrade);
  if (!folder) return kInterrupted;
  Record& record = folder->record();
  if (!SharedPlan::in(settings.out)) return 0;  // another process has just collected all

  Plan plan{.submissions = {}, .only = facts.only, .listed = record.listed()};
  std::map<std::string, std::size_t> numbers;
  for (std::size_t i = 0; i < facts.hand_ins; ++i)
    plan.submissions.push_back(shared.get<Submission>(numbered("hand-ins", i)));
  for (const std::size_t i : facts.asked) numbers[plan.submissions[i].name] = i;
  const auto has_result = [&](std::size_t i) { return shared.has(numbered("results", i)); };
  std::set<std::size_t> there;  // more may come while these are merged
  std::ranges::copy_if(facts.asked, std::inserter(there, there.end()), has_result);
  Collected collected;
  if (shared.has("collected") && !settings.regrade) collected = shared.get<Collected>("collected");
  const std::set<std::size_t> before(collected.hand_ins.begin(), collected.hand_ins.end());
  TimingByExercise reference;
  if (shared.has("first")) reference = shared.get<FirstTask>("first").reference;
  const auto fingerprint = [&](const Submission& one) {
    const auto number = numbers.find(one.name);
    return number == numbers.end() || before.contains(number->second)
               ? record.find(one.name).value().result.fingerprint
               : shared.fingerprint(number->second);
  };
  std::mutex taking;
  const auto take = [&](const Submission& one) -> std::optional<Graded> {
    const std::size_t number = numbers.at(one.name);
    if (!there.contains(number)) return {};
    std::optional<Graded> graded = shared.graded(number);
    const std::lock_guard lock(taking);
    if (graded->problems.empty()) collected.hand_ins.push_back(number);
    return graded;
  };
  const Grader grader{course,
                      reference,
                      facts.made_by,
                      options.settings.study && !options.settings.exercise,
                      fingerprint,
                      take,
                      [](const Submission&, Graded&) {}};
  const Batch batch = grade_batch(grader, plan, settings, record, interrupted);
  const int code = say_graded(made_by->isolation, options, plan, batch, record);
  if (interrupted) return kInterrupted;
  if (there.size() == facts.asked.size()) {
    shared.remove();
    return code;
  }
  shared.put("collected", collected);
  std::vector<std::size_t> missing;
  std::ranges::remove_copy_if(facts.asked, std::back_inserter(missing), has_result);
  std::vector<std::size_t> nobody = say_missing(shared, missing);
  std::erase_if(nobody, has_result);
  const bool is_last = options.slurm.step.front() == "last";
  if (const auto came = std::ranges::count_if(facts.asked, has_result) - std::ssize(there); came > 0) {
    std::cerr << "hairgrade: " << came << " results have come meanwhile\n";
    if (is_last) {
      folder.reset();
      return collect(std::move(options));
    }
  }
  if (nobody.empty()) return 3;
  // A person may have mended nodes. The last job sends again only if it leaves out one more node: it can't go
  // on for ever.
  if (!is_last) shared.forget_refusals();
  const std::vector<SentArray> arrays = shared.arrays();
  if (is_last && (arrays.empty() || arrays.back().without == shared.nodes_that_refused())) {
    std::cerr << "hairgrade: hairgrade collect " << shell_word(settings.out.string()) << " sends "
              << nobody.size() << " hand-ins again\n";
    return 3;
  }
  const Sender sender(shared, options);
  if (!shared.has("first") && !sender.try_a_node(interrupted)) return kInterrupted;
  sender.send(nobody);
  return 3;
}

Command add_collect(CLI::App& hairgrade) {
  const auto folder = std::make_shared<fs::path>();
  CLI::App* command = hairgrade.add_subcommand(
      "collect", "Take what a cluster has graded into the record, and send again what is missing");
  needed_elsewhere(command->add_option("GRADES", *folder, "The folder that grade --slurm was given as --out"),
                   *folder, kGrades);
  return {
      command, [folder]() -> int {
        const std::optional<SharedPlan> plan = SharedPlan::in(*folder);
        if (!plan)
          throw BadInput(printable(folder->string(), 4096) + ": none of its hand-ins are on a cluster");
        const auto facts = plan->get<PlanFacts>("plan");
        std::vector<std::string> words = facts.words;
        words.insert(words.end(), {"--slurm-step", "collect", fs::absolute(*plan / "").string()});
        return hair::exit_code_of(hair::start_program({.words = words, .folder = facts.folder})).value_or(1);
      }};
}

}  // namespace grader::tool
