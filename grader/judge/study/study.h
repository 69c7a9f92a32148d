// STAFF ONLY. Error against time of a submission's code, compared with the reference in an identical worker.
//
// Both run each part with the same numbers of steps, alternating: student, reference, student, reference, and
// so on through all numbers of steps; in the next round the reference is first. So other load of the machine
// affects both, and the ratio compares times that were measured side by side. The first round measures errors
// and warms up; its times are shown only if no round was measured to its end. Runs are deterministic: a
// measured run must give the same result as the first one, or it is shown as broken.
//
// A study neither gives nor takes points.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "grader/judge/run/played.h"
#include "grader/judge/student/student.h"
#include "grader/judge/study/scenes.h"
#include "grader/result/study.h"

namespace grader::inline judge {

// Runs motions for a study and measures the time, in a worker that has all of a submission's objects.
//
// The clock is the kernel's CPU time of all threads of the worker, which we read after each answer. A run is
// charged with all CPU time since the previous answer. So code can shift its work to an earlier or later run.
// It never sees a time and can hide none; but it can remember an earlier answer, which then costs no time.
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

struct StudySettings {
  int rounds = 5;                  // the number of measured rounds
  double least_seconds = 0.002;    // the reference's runs are repeated to take this time at least
  double most_seconds = 2;         // student's CPU time for a part; the rest is left out
  double most_wall_seconds = 120;  // bounds the student's runs of all parts, so that sleeping code ends
};

// Reports each run in its order: true for the student's, and its number of steps.
using Asked = std::function<void(bool student, int steps)>;

// `twin` is another worker of the reference, whose times show the noise.
PartStudy study_part(const StudiedPart& part, const Truth& truth, Runner& student, Runner& reference,
                     Runner& twin, const StudySettings& settings, const Asked& asked = {});

}  // namespace grader::judge
