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
  Batch batch;
  std::vector<Submission>& submissions = plan.submissions;
  const std::optional<std::string>& only = plan.only;
  std::optional<Record> stage;
  if (settings.regrade && !current.names().empty()) {
    stage.emplace(settings.out, current.hand_in() + kStage);
    stage->begin_stage(grader.made_by);
  }
  Record& record = stage ? *stage : current;
  const bool resume = settings.resume || stage;
  const NamesForPeople people = record.names_for_people();
  const std::optional<HiddenNames> hidden = record.hidden_names();
  const auto start = std::chrono::steady_clock::now();
  TimingByExercise reference = grader.reference;
  if (settings.merge) reference.merge(record.costs().reference);
  const std::size_t asked = only ? 1 : submissions.size();
  LastRun run{.jobs = settings.jobs, .began = record.now(), .asked = static_cast<int>(asked)};
  // A single new hand-in leaves an interrupted run as it is.
  const std::optional<LastRun> before = record.costs().last_run;
  const bool is_part = only && before && !before->is_whole();
  if (is_part) run = *before;
  record.set_run(reference, run);
  record.set_listed(plan.listed);
  record.set_rules(settings.rules);
  if (const std::vector<std::string> there = record.names();
      !there.empty() && !stage)  // pages of an earlier run say that this process works
    write_class_files(settings.out, record, {there.begin(), there.end()});
  std::string failure;
  std::set<std::string> written;
  Progress progress(asked);
  std::map<std::size_t, Graded> ended_by_the_clock;  // by the submission's place
  std::mutex shared;                                 // guards the variables above; the record guards itself
  std::atomic<std::size_t> next = 0;

  const auto handed_in_of = [](const Submission& submission) {
    return HandedIn{submission.handed_in, hash_of_files(submission), submission.marked_late};
  };
  const auto earlier_of = [&](const Submission& submission) {
    return resume || settings.merge ? record.find(submission.name) : std::nullopt;
  };
  // Reports the times of files that a corrected table changes.
  const auto compare_times = [&](const std::string& name, const std::string& was, const std::string& now) {
    if (was.empty() || now.empty() || was == now) return;
    const auto shown = [](const std::string& time) { return time == "-" ? "unknown" : time; };
    const std::lock_guard lock(shared);
    batch.remarks.push_back(called(name, people) + ": its time of hand-in was " + shown(was) + " and is " +
                            shown(now) + " now");
  };
  const auto keep = [&](const Submission& submission, Graded graded) {
    const HandedIn handed_in = handed_in_of(submission);
    Recorded one{std::move(graded.result), {}, std::move(graded.timing)};
    if (const std::optional<Recorded> earlier = earlier_of(submission); settings.merge && earlier)
      keep_other_exercises(one, *earlier, grader.course);
    one.result.studied = graded.study.has_value();
    one.study = std::move(graded.study);
    compare_times(submission.name, record.put(one, handed_in), handed_in.time);
    if (std::optional<Recorded> now = record.find_decided(submission.name)) one = std::move(*now);
    if (hidden) hide(*hidden, one.result);
    if (!stage) write_student_files(record.pages(), one, people);
    const std::lock_guard lock(shared);
    progress.step(in_a_line(one.result, people));
    written.insert(submission.name);
    batch.problems.insert(batch.problems.end(), graded.problems.begin(), graded.problems.end());
    ++batch.graded;
    ++batch.done;
    if (is_part) return;
    run.done = static_cast<int>(batch.done);
    record.set_run(reference, run);  // shows others that a killed process was at work
  };

  const auto grade_one = [&](std::size_t place) {
    Submission& submission = submissions[place];
    if (only && *only != submission.name) return;
    const std::optional<Recorded> earlier = earlier_of(submission);
    if (resume && earlier) {
      const bool complete = earlier->result.studied || !grader.studies;
      if (complete && earlier->result.origin == submission.origin &&
          earlier->result.fingerprint == grader.fingerprint(submission)) {
        const HandedIn handed_in = handed_in_of(submission);
        compare_times(submission.name, record.set_handed_in(submission.name, handed_in), handed_in.time);
        const Recorded now = record.find_decided(submission.name).value_or(*earlier);
        const std::lock_guard lock(shared);
        ++batch.done;
        progress.step(in_a_line(now.result, people), false);
        return;
      }
    }
    std::optional<Graded> graded = grader.grade(submission);
    // Ctrl-C also ends the suite: its output is no result.
    if (interrupted || !graded) return;
    if (graded->result.ended_by_the_clock.empty()) return keep(submission, std::move(*graded));
    const std::lock_guard lock(shared);
    ended_by_the_clock.emplace(place, std::move(*graded));
  };
  const auto unless_it_fails = [&](const auto& work) {
    try {
      work();
    } catch (const std::exception& problem) {  // the record or reports can't be written: stop
      const std::lock_guard lock(shared);
      failure = problem.what();
      next = submissions.size();
    }
  };
  const auto work = [&] {
    for (std::size_t i = next++; i < submissions.size() && !interrupted; i = next++)
      unless_it_fails([&] { grade_one(i); });
  };
  std::vector<std::jthread> threads;
  for (int i = 0; i < settings.jobs; ++i) threads.emplace_back(work);
  for (std::jthread& thread : threads) thread.join();
  // Grades one at a time: the machine has nothing else to do for us.
  for (auto& [place, graded] : ended_by_the_clock) {
    if (interrupted || !failure.empty()) break;
    unless_it_fails([&, &place = place, &graded = graded] {
      grader.grade_again(submissions[place], graded);
      if (!interrupted) keep(submissions[place], std::move(graded));
    });
  }
  if (!failure.empty()) throw BadInput(failure);

  batch.interrupted = interrupted;
  run.wall_seconds = settings.seconds_before +
                     std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.graded = batch.graded;
  if (!is_part) {
    run.done = static_cast<int>(batch.done);
    run.ended = record.now();
  }
  record.set_run(reference, run);
  if (stage) {
    if (!batch.interrupted && batch.problems.empty()) batch.ungraded = current.take_stage();
    batch.staged = batch.interrupted || !batch.problems.empty() || !batch.ungraded.empty();
    written.clear();
  }
  batch.results = write_class_files(settings.out, current, written);
  for (const std::string& name : current.names())
    std::ranges::move(current.conflicts(name), std::back_inserter(batch.conflicts));
  batch.kept = static_cast<int>(batch.results.size()) - batch.graded;
  return batch;
}

}  // namespace grader::class_folder
