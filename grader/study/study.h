// STAFF ONLY. Error against time of a submission's code, beside the reference's in an identical worker.
//
// Both play each part with the same numbers of steps, in turns: student, reference, student, reference, and so on through
// all numbers of steps; then again with the reference first, and so on. What else the machine does meets both, and their
// ratio is of times that were taken side by side. A first round is for errors, and warms up; its times
// are shown only where no round was measured to its end. Plays are deterministic: what is measured must end as it did at
// first, or it is shown as broken.
//
// Nothing of it gives points or takes any.
#pragma once

#include <functional>

#include "grader/report/study_result.h"
#include "grader/study/parts.h"
#include "grader/study/player.h"
#include "grader/study/truth.h"

namespace grader {

struct StudySettings {
  int rounds = 5;                  // that are measured
  double least_seconds = 0.002;    // a play takes the reference so much, or is repeated until it does
  double most_seconds = 2;         // of the student's CPU time, for one part: then the rest is left out
  double most_wall_seconds = 120;  // of the student's plays, for all parts: ends code that dozes
};

// The order in which the two were asked, for whoever wants to see it: whether it was the student, and with how many
// steps.
using Asked = std::function<void(bool student, int steps)>;

PartStudy study_part(const StudiedPart& part, const Truth& truth, Player& student, Player& reference,
                     const StudySettings& settings, const Asked& asked = {});

}  // namespace grader
