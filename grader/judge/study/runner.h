// STAFF ONLY. Runs motions for a study and measures the time, in a worker that has all of a submission's
// objects.
//
// The clock is the kernel's CPU time of all threads of the worker, which we read after each answer. A run is
// charged with all CPU time since the previous answer. So code can shift its work to an earlier or later run.
// It never sees a time and can hide none; but it can remember an earlier answer, which then costs no time.
#pragma once

#include <optional>
#include <string>

#include "grader/judge/run/played.h"
#include "grader/judge/student/student.h"
#include "grader/judge/study/scenes.h"

namespace grader::inline judge {

struct Play {
  Played played;
  std::optional<double> seconds;  // CPU time of all repetitions together; nothing: the worker was restarted
};

class Runner {
 public:
  virtual ~Runner() = default;
  // `scene` is the parsed text. Throws CaseFailed or MalformedMessage.
  virtual Play play(const SceneText& text, const hair::Scene& scene, int times) = 0;
};

class WorkerRunner : public Runner {
 public:
  explicit WorkerRunner(Student& student) : student_(student) {}
  Play play(const SceneText& text, const hair::Scene& scene, int times) override;

 private:
  Student& student_;
  int starts_ = 0;  // counts the worker's starts at the last reading of the clock
  double clock_ = 0;
};

// Forwards to another runner, until that one times out, breaks the rules, crashes for the third time, or has
// used up its wall time. After that each run fails at once.
class UntilItGivesUp : public Runner {
 public:
  static constexpr int kMostCrashes = 3;

  UntilItGivesUp(Runner& runner, double most_wall_seconds) : runner_(runner), wall_left_(most_wall_seconds) {}
  Play play(const SceneText& text, const hair::Scene& scene, int times) override;

 private:
  Runner& runner_;
  double wall_left_;
  int crashes_ = 0;
  std::optional<CaseFailed> end_;
};

}  // namespace grader::judge
