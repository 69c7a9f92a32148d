// STAFF ONLY.
#include "grader/tool/batch.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <map>
#include <mutex>
#include <thread>

#include "grader/course/bad_input.h"
#include "grader/report/report.h"
#include "grader/tool/timing.h"

namespace grader {
namespace {

// One line on a terminal; nothing in a pipe.
class Progress {
 public:
  explicit Progress(std::size_t total) : total_(total), shown_(isatty(STDERR_FILENO) != 0) {}
  ~Progress() {
    if (shown_) std::cerr << "\r\033[K" << std::flush;
  }
  void step(const std::string& name) {
    ++done_;
    if (shown_) std::cerr << "\r\033[K[" << done_ << "/" << total_ << "] " << name << std::flush;
  }

 private:
  std::size_t total_, done_ = 0;
  bool shown_;
};

}  // namespace

Batch grade_batch(const Grading& grading, const std::vector<Submission>& submissions,
                  const BatchSettings& settings, const std::atomic<bool>& interrupted) {
  if (settings.only && std::none_of(submissions.begin(), submissions.end(),
                                    [&](const Submission& s) { return s.name == *settings.only; }))
    throw BadInput("--only " + *settings.only + ": no submission has that name; there are " +
                   std::to_string(submissions.size()));
  std::error_code error;
  std::filesystem::create_directories(settings.out, error);
  if (error || access(settings.out.c_str(), W_OK) != 0)
    throw BadInput(settings.out.string() + ": reports can't be written there" +
                   (error ? ": " + error.message() : ""));

  const auto start = std::chrono::steady_clock::now();
  Batch batch;
  std::map<std::string, TimingByExercise> timing;
  std::string failure;
  Progress progress(settings.only ? 1 : submissions.size());
  std::mutex shared;  // guards all of the above
  std::atomic<std::size_t> next = 0;

  auto grade_one = [&](const Submission& submission) {
    const bool selected = !settings.only || *settings.only == submission.name;
    if (!selected || settings.resume) {
      std::optional<SubmissionResult> earlier = read_results(settings.out, submission.name);
      if (earlier && (!selected || earlier->fingerprint == grading.fingerprint(submission))) {
        const std::lock_guard lock(shared);
        batch.results.push_back(std::move(*earlier));
        ++batch.kept;
        if (selected) progress.step(submission.name);
        return;
      }
      if (!selected) return;
    }
    Graded graded = grading.grade(submission);
    // Ctrl-C reaches the suite, too: what it left is no result.
    if (interrupted) return;
    write_submission_reports(settings.out, graded.result);
    const std::lock_guard lock(shared);
    batch.results.push_back(std::move(graded.result));
    timing[submission.name] = std::move(graded.timing);
    ++batch.graded;
    progress.step(submission.name);
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
  std::sort(batch.results.begin(), batch.results.end(),
            [](const SubmissionResult& a, const SubmissionResult& b) { return a.name < b.name; });
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_class_reports(settings.out, batch.results);
  write_timing(settings.out, grading.reference_timing(), timing, seconds, batch.graded, settings.jobs);
  return batch;
}

}  // namespace grader
