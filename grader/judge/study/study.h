// STAFF ONLY. Error against time of a submission's code, beside the reference in an identical worker.
//
// Both play each part with the same numbers of steps, alternating: student, reference, student, reference,
// and so on through all numbers of steps; in the next round the reference is first. So other load of the
// machine affects both, and the ratio compares times that were measured side by side. The first round
// measures errors and warms up; its times are shown only if no round was measured to its end. Plays are
// deterministic: a measured play must give the same result as the first one, or it is shown as broken.
//
// A study neither gives nor takes points.
#pragma once

#include <functional>

#include "grader/judge/study/parts.h"
#include "grader/judge/study/player.h"
#include "grader/judge/study/truth.h"
#include "grader/result/study.h"

namespace grader::inline judge {

struct StudySettings {
  int rounds = 5;                  // the number of measured rounds
  double least_seconds = 0.002;    // the reference's plays are repeated to take at least this time
  double most_seconds = 2;         // of the student's CPU time, for one part: then the rest is left out
  double most_wall_seconds = 120;  // of the student's plays, for all parts: stops code that sleeps
};

// Reports the order of plays: whether it is the student's, and its number of steps.
using Asked = std::function<void(bool student, int steps)>;

PartStudy study_part(const StudiedPart& part, const Truth& truth, Player& student, Player& reference,
                     const StudySettings& settings, const Asked& asked = {});

}  // namespace grader::judge
