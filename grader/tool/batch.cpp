// STAFF ONLY.
#include "grader/tool/batch.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <mutex>
#include <thread>

#include "grader/course/input.h"
#include "grader/report/columns.h"
#include "grader/report/picture_files.h"
#include "grader/report/report.h"
#include "grader/report/text.h"
#include "grader/tool/folder_of_grades.h"
#include "grader/tool/origins.h"
#include "grader/tool/progress.h"
#include "grader/tool/timing.h"

namespace grader {
namespace {

std::string names_of(const std::vector<Submission>& submissions) {
  constexpr std::size_t kMost = 20;
  std::string names;
  for (std::size_t i = 0; i < submissions.size() && i < kMost; ++i)
    names += (i > 0 ? ", " : "") + submissions[i].name;
  return names + (submissions.size() > kMost ? " and more" : "");
}

// Adds what an earlier run found of exercises that this one was not asked for, in the course's order, and of
// all of them together, but for a study: that would be of code that is not this. Then no fingerprint is right for all of
// it.
void keep_other_exercises(SubmissionResult& result, const std::optional<SubmissionResult>& earlier,
                          const Course& course) {
  if (!earlier) return;
  for (const ExerciseResult& old : earlier->exercises)
    if (std::none_of(result.exercises.begin(), result.exercises.end(),
                     [&](const ExerciseResult& one) { return one.id == old.id; })) {
      result.exercises.push_back(old);
      result.fingerprint.clear();
      if (std::ranges::count(earlier->ended_by_the_clock, old.id) > 0)
        result.ended_by_the_clock.push_back(old.id);
    }
  const auto place = [&](const ExerciseResult& one) { return course.find(one.id); };
  std::sort(result.exercises.begin(), result.exercises.end(),
            [&](const ExerciseResult& a, const ExerciseResult& b) { return place(a) < place(b); });
  result.runs = earlier->runs;
}

bool has(const std::vector<SubmissionResult>& results, const std::string& name) {
  return std::any_of(results.begin(), results.end(),
                     [&](const SubmissionResult& result) { return result.name == name; });
}

// A submission's row, as it appears before the table is there: "alice  S1 32  S2 crashed  of 52: 32".
std::string in_a_line(const SubmissionResult& result) {
  std::string line = printable(result.name);
  for (const ExerciseResult& exercise : result.exercises)
    line += "  " + exercise.id + " " + in_short(exercise);
  return line + "  of " + shown_points(max_points(result)) + ": " + short_points(points(result));
}

// The rows of those whom this batch did not grade: other people's, and what an interrupted batch did not reach.
void add_what_else_is_there(Batch& batch, const std::filesystem::path& folder) {
  for (const std::string& name : submissions_in(folder)) {
    if (has(batch.results, name)) continue;
    if (std::optional<SubmissionResult> earlier = read_results(folder, name))
      batch.results.push_back(std::move(*earlier));
    else
      batch.unreadable.push_back(name);
  }
  std::sort(batch.results.begin(), batch.results.end(),
            [](const SubmissionResult& a, const SubmissionResult& b) { return a.name < b.name; });
}

}  // namespace

Batch grade_batch(const Grading& grading, std::vector<Submission> submissions, const BatchSettings& settings,
                  const std::atomic<bool>& interrupted) {
  if (settings.only && std::none_of(submissions.begin(), submissions.end(),
                                    [&](const Submission& s) { return s.name == *settings.only; }))
    throw BadInput("--only " + *settings.only + ": no submission has that name; there are " +
                   names_of(submissions));
  Batch batch;
  const std::optional<FolderOfGrades> folder =
      FolderOfGrades::open(settings.out, grading.made_by(), interrupted, std::cerr);
  if (!folder) {
    batch.interrupted = true;
    batch.began = false;
    return batch;
  }
  for (const std::string& line : settle_origins(settings.out, submissions, settings.only, settings.replace))
    std::cerr << "hairgrade: " << line << "\n";
  const auto start = std::chrono::steady_clock::now();
  batch.problems = grading.reference().problems;
  Timing timing(settings.out, grading.reference().timing, settings.merge);
  if (!timing.damage().empty())
    std::cerr << "hairgrade: " << timing.damage() << "; costs of earlier runs are left out\n";
  std::string failure;
  Progress progress(settings.only ? 1 : submissions.size());
  std::mutex shared;  // guards all of the above
  std::atomic<std::size_t> next = 0;

  auto grade_one = [&](const Submission& submission) {
    if (settings.only && *settings.only != submission.name) return;
    if (settings.resume) {
      std::optional<SubmissionResult> earlier = read_results(settings.out, submission.name);
      const bool complete = earlier && (earlier->studied || !grading.reference().study);
      if (complete && earlier->origin == submission.origin &&
          earlier->fingerprint == grading.fingerprint(submission)) {
        const std::lock_guard lock(shared);
        progress.step(in_a_line(*earlier));
        batch.results.push_back(std::move(*earlier));
        return;
      }
    }
    Graded graded = grading.grade(submission);
    // Ctrl-C reaches the suite, too: what it left is no result.
    if (interrupted) return;
    if (settings.merge)
      keep_other_exercises(graded.result, read_results(settings.out, submission.name), grading.course());
    {
      const std::lock_guard lock(shared);
      timing.add(submission.name, graded.timing);  // before the result: no result is there without its cost
    }
    if (graded.study) {
      graded.result.studied = true;
      write_study(settings.out, graded.result, *graded.study, *grading.reference().study);
    } else if (!graded.result.studied) {
      remove_study(settings.out, graded.result);
    }
    write_submission_reports(settings.out, graded.result);
    const std::lock_guard lock(shared);
    progress.step(in_a_line(graded.result));
    batch.results.push_back(std::move(graded.result));
    batch.problems.insert(batch.problems.end(), graded.problems.begin(), graded.problems.end());
    ++batch.graded;
  };
  auto work = [&] {
    for (std::size_t i = next++; i < submissions.size() && !interrupted; i = next++) {
      try {
        grade_one(submissions[i]);
      } catch (const std::exception& problem) {  // reports can't be written: no use in going on
        const std::lock_guard lock(shared);
        failure = problem.what();
        next = submissions.size();
      }
    }
  };
  std::vector<std::jthread> threads;
  for (int i = 0; i < settings.jobs; ++i) threads.emplace_back(work);
  for (std::jthread& thread : threads) thread.join();
  if (!failure.empty()) throw BadInput(failure);

  batch.interrupted = interrupted;
  add_what_else_is_there(batch, settings.out);
  batch.kept = static_cast<int>(batch.results.size()) - batch.graded;
  for (const Submission& submission : submissions) batch.finished += has(batch.results, submission.name);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_class_reports(settings.out, batch.results);
  remove_unshown_pictures(settings.out);
  timing.finish(batch.results, {seconds, batch.graded, settings.jobs});
  return batch;
}

}  // namespace grader
