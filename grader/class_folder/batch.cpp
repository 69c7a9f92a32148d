// STAFF ONLY. Grades submissions by several threads, and puts each result into the record.
#include "grader/class_folder/batch.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "grader/class_folder/blind.h"
#include "grader/class_folder/class_files.h"
#include "grader/class_folder/progress.h"
#include "grader/course/input.h"
#include "grader/report/facts/columns.h"
#include "grader/report/facts/text.h"

namespace grader::inline class_folder {
namespace {

// Adds an earlier run's results and costs of exercises that this run does not grade, in the course's order,
// but not its study, whose code may have changed. A mixed result has no fingerprint.
void keep_other_exercises(Recorded& one, const Recorded& earlier, const Course& course) {
  SubmissionResult& result = one.result;
  for (const ExerciseResult& old : earlier.result.exercises)
    if (std::none_of(result.exercises.begin(), result.exercises.end(),
                     [&](const ExerciseResult& other) { return other.id == old.id; })) {
      result.exercises.push_back(old);
      result.fingerprint.clear();
      if (std::ranges::count(earlier.result.ended_by_the_clock, old.id) > 0)
        result.ended_by_the_clock.push_back(old.id);
    }
  const auto place = [&](const ExerciseResult& exercise) { return course.find(exercise.id); };
  std::sort(result.exercises.begin(), result.exercises.end(),
            [&](const ExerciseResult& a, const ExerciseResult& b) { return place(a) < place(b); });
  one.costs.insert(earlier.costs.begin(), earlier.costs.end());
}

// Returns a submission in one line, as it appears before the table: "alice  S1 32  S2 crashed  of 52: 32".
std::string in_a_line(const SubmissionResult& result, const NamesForPeople& people) {
  std::string line = people.contains(result.name) ? called(result.name, people) : printable(result.name);
  for (const ExerciseResult& exercise : result.exercises)
    line += "  " + exercise.id + " " + in_short(exercise);
  const double most = max_points(result);
  return line + (most > 0 ? "  of " + shown_points(most) : std::string("  extra credit")) + ": " +
         short_points(points(result));
}

// A batch at work: its threads share it.
class RunningBatch {
 public:
  RunningBatch(const Grader& grader, Plan plan, const BatchSettings& settings, Record& current,
               const std::atomic<bool>& interrupted);
  void grade_all();
  Batch finish();

 private:
  Record& begin_record();
  HandedIn handed_in_of(const Submission& submission) const {
    return {submission.handed_in, hash_of_files(submission), submission.marked_late};
  }
  void compare_times(const std::string& name, const std::string& was, const std::string& now);
  bool take_earlier(const Submission& submission);
  void keep(const Submission& submission, Graded graded);
  void grade_one(std::size_t place);
  template <class Work>
  void unless_it_fails(const Work& work);

  const Grader& grader_;
  Plan plan_;
  const BatchSettings& settings_;
  Record& current_;
  const std::atomic<bool>& interrupted_;
  std::optional<Record> stage_;
  Record& record_ = begin_record();
  const bool resume_ = settings_.resume || stage_;
  const NamesForPeople people_ = record_.names_for_people();
  const std::optional<HiddenNames> hidden_ = record_.hidden_names();
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  TimingByExercise reference_ = grader_.reference;
  const std::size_t asked_ = plan_.only ? 1 : plan_.submissions.size();
  LastRun run_{.jobs = settings_.jobs, .began = record_.now(), .asked = static_cast<int>(asked_)};
  bool is_part_ = false;  // a single new hand-in leaves an interrupted run as it is
  Batch batch_;
  std::string failure_;
  std::set<std::string> written_;
  std::optional<Progress> progress_;
  std::map<std::size_t, Graded> ended_by_the_clock_;  // by the submission's place
  std::mutex shared_;  // guards run_ to ended_by_the_clock_ while threads work; the record guards itself
  std::atomic<std::size_t> next_ = 0;
};

RunningBatch::RunningBatch(const Grader& grader, Plan plan, const BatchSettings& settings, Record& current,
                           const std::atomic<bool>& interrupted)
    : grader_(grader),
      plan_(std::move(plan)),
      settings_(settings),
      current_(current),
      interrupted_(interrupted) {
  if (settings_.merge) reference_.merge(record_.costs().reference);
  const std::optional<LastRun> before = record_.costs().last_run;
  is_part_ = plan_.only && before && !before->is_whole();
  if (is_part_) run_ = *before;
  record_.set_run(reference_, run_);
  record_.set_listed(plan_.listed);
  record_.set_rules(settings_.rules);
  if (const std::vector<std::string> there = record_.names();
      !there.empty() && !stage_)  // pages of an earlier run say that this process works
    write_class_files(settings_.out, record_, {there.begin(), there.end()});
}

// A regrade goes into a record of its own, until all are there.
Record& RunningBatch::begin_record() {
  if (!settings_.regrade || current_.names().empty()) return current_;
  stage_.emplace(settings_.out, current_.hand_in() + kStage);
  stage_->begin_stage(grader_.made_by);
  return *stage_;
}

// Reports the times of files that a corrected table changes.
void RunningBatch::compare_times(const std::string& name, const std::string& was, const std::string& now) {
  if (was.empty() || now.empty() || was == now) return;
  const auto shown = [](const std::string& time) { return time == "-" ? "unknown" : time; };
  const std::lock_guard lock(shared_);
  batch_.remarks.push_back(called(name, people_) + ": its time of hand-in was " + shown(was) + " and is " +
                           shown(now) + " now");
}

void RunningBatch::keep(const Submission& submission, Graded graded) {
  const HandedIn handed_in = handed_in_of(submission);
  Recorded one{std::move(graded.result), {}, std::move(graded.timing)};
  if (settings_.merge)
    if (const std::optional<Recorded> earlier = record_.find(submission.name))
      keep_other_exercises(one, *earlier, grader_.course);
  one.result.studied = graded.study.has_value();
  one.study = std::move(graded.study);
  compare_times(submission.name, record_.put(one, handed_in), handed_in.time);
  if (std::optional<Recorded> now = record_.find_decided(submission.name)) one = std::move(*now);
  if (hidden_) hide(*hidden_, one.result);
  if (!stage_) write_student_files(record_.pages(), one, people_);
  const std::lock_guard lock(shared_);
  progress_->step(in_a_line(one.result, people_));
  written_.insert(submission.name);
  batch_.problems.insert(batch_.problems.end(), graded.problems.begin(), graded.problems.end());
  ++batch_.graded;
  ++batch_.done;
  if (is_part_) return;
  run_.done = static_cast<int>(batch_.done);
  record_.set_run(reference_, run_);  // shows others that a killed process was at work
}

// Takes the earlier result of the same files and the same suite, and enters a corrected time. Returns false
// if the submission must be graded.
bool RunningBatch::take_earlier(const Submission& submission) {
  const std::optional<Recorded> earlier = resume_ ? record_.find(submission.name) : std::nullopt;
  if (!earlier || (grader_.studies && !earlier->result.studied) ||
      earlier->result.origin != submission.origin ||
      earlier->result.fingerprint != grader_.fingerprint(submission))
    return false;
  const HandedIn handed_in = handed_in_of(submission);
  compare_times(submission.name, record_.set_handed_in(submission.name, handed_in), handed_in.time);
  const Recorded now = record_.find_decided(submission.name).value_or(*earlier);
  const std::lock_guard lock(shared_);
  ++batch_.done;
  progress_->step(in_a_line(now.result, people_), false);
  return true;
}

void RunningBatch::grade_one(std::size_t place) {
  const Submission& submission = plan_.submissions[place];
  if ((plan_.only && *plan_.only != submission.name) || take_earlier(submission)) return;
  std::optional<Graded> graded = grader_.grade(submission);
  // Ctrl-C also ends the suite: its output is no result.
  if (interrupted_ || !graded) return;
  if (graded->result.ended_by_the_clock.empty()) return keep(submission, std::move(*graded));
  const std::lock_guard lock(shared_);
  ended_by_the_clock_.emplace(place, std::move(*graded));
}

template <class Work>
void RunningBatch::unless_it_fails(const Work& work) {
  try {
    work();
  } catch (const std::exception& problem) {  // the record or reports can't be written: stop
    const std::lock_guard lock(shared_);
    failure_ = problem.what();
    next_ = plan_.submissions.size();
  }
}

void RunningBatch::grade_all() {
  progress_.emplace(asked_);
  const auto work = [&] {
    for (std::size_t i = next_++; i < plan_.submissions.size() && !interrupted_; i = next_++)
      unless_it_fails([&] { grade_one(i); });
  };
  std::vector<std::jthread> threads;
  for (int i = 0; i < settings_.jobs; ++i) threads.emplace_back(work);
  for (std::jthread& thread : threads) thread.join();
  // Grades one at a time: the machine has nothing else to do for us.
  for (auto& [place, graded] : ended_by_the_clock_) {
    if (interrupted_ || !failure_.empty()) break;
    const Submission& submission = plan_.submissions[place];
    unless_it_fails([&, &graded = graded] {
      grader_.grade_again(submission, graded);
      if (!interrupted_) keep(submission, std::move(graded));
    });
  }
  if (!failure_.empty()) throw BadInput(failure_);
}

Batch RunningBatch::finish() {
  batch_.interrupted = interrupted_;
  run_.wall_seconds = settings_.seconds_before +
                      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  run_.graded = batch_.graded;
  if (!is_part_) {
    run_.done = static_cast<int>(batch_.done);
    run_.ended = record_.now();
  }
  record_.set_run(reference_, run_);
  if (stage_) {
    if (!batch_.interrupted && batch_.problems.empty()) batch_.ungraded = current_.take_stage();
    batch_.staged = batch_.interrupted || !batch_.problems.empty() || !batch_.ungraded.empty();
    written_.clear();
  }
  batch_.results = write_class_files(settings_.out, current_, written_);
  for (const std::string& name : current_.names())
    std::ranges::move(current_.conflicts(name), std::back_inserter(batch_.conflicts));
  batch_.kept = static_cast<int>(batch_.results.size()) - batch_.graded;
  return std::move(batch_);
}

}  // namespace

Grader grader_here(const Grading& grading) {
  return {grading.course(),
          grading.reference(),
          to_json(grading.made_by()),
          grading.studies(),
          [&](const Submission& submission) { return grading.fingerprint(submission); },
          [&](const Submission& submission) { return grading.grade(submission); },
          [&](const Submission& submission, Graded& graded) { grading.grade_again(submission, graded); }};
}

void enter_plan(Plan& plan, const BatchSettings& settings, Record& record) {
  if (plan.blind) record.set_blind();
  record.put_people(hand_ins_of(plan.submissions),
                    settings.roster ? std::optional(settings.roster->people()) : std::nullopt, plan.only);
  for (Submission& one : plan.submissions)
    if (!plan.only || *plan.only == one.name) one.drawn_from = record.drawn_from(one.name);
}

Batch grade_batch(const Grader& grader, Plan plan, const BatchSettings& settings, Record& current,
                  const std::atomic<bool>& interrupted) {
  RunningBatch batch(grader, std::move(plan), settings, current, interrupted);
  batch.grade_all();
  return batch.finish();
}

}  // namespace grader::class_folder
