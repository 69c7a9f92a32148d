// Runs a scene for a page: the process with the exercises' code. It reads lines from its standard input,
// first one of settings, then "go", "pause", "step" and "rate 0.5", and ends when the input does. It writes
// lines to its standard output:
//
//   {"kind":"start", ...}   the motion (hair/view/motion.h) at the start, steps and methods
//   {"kind":"frame", ...}   "time", s; "steps"; "values", one a series; "last" (MotionFrames::last_json)
//   {"kind":"state", ...}   "going"; "ended" and "blow_up" as in the motion, if it is over
//   {"kind":"trouble", ...} "text": the reason why the run can't start or continue
//   . 17                    steps so far: at least one such line a second while the code returns
//   @ H6 FUNCTION           the exercise that it is in (whereabouts.h)
//
// Text that the exercises' code prints goes to the standard errors.
#pragma once

#include <string>

#include "hair/course/course.h"

namespace hair {

// Returns the process's exit code.
int play_for_page(const std::string& scene, const Course& course);

}  // namespace hair
