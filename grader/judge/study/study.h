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

#include "grader/judge/study/runner.h"
#include "grader/judge/study/truth.h"
#include "grader/result/study.h"

namespace grader::inline judge {

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
