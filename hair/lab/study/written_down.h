// The same method in a program that was written for one kind of strand: a study's lines "written down" show
// what a method costs without the parts that let exercises be replaced. The staff alone has such a program.
#pragma once

#include <atomic>
#include <optional>

#include "hair/lab/study/sweep.h"

namespace hair {

struct WrittenRun {
  double seconds;     // CPU time
  Eigen::VectorXd x;  // the positions at the end
};

// Runs the whole problem. Nothing if there is no such program for the problem or the method.
std::optional<WrittenRun> run_written_down(const Problem& problem, const StudyMethod& method,
                                           int steps_per_moment);

// Adds a sweep to the study for each one that there is such a program for: the same steps and errors, with
// the program's times. Runs that end elsewhere are left out.
void add_written_down(const Problem& problem, Study& study, const std::atomic<bool>& interrupted);

}  // namespace hair
