// STAFF ONLY. H5: hidden cases on what stays as it is, and on what is reported.
#include <cmath>

#include "grader/suite/H5/answers.h"
#include "grader/suite/H5/categories.h"
#include "grader/suite/implicit_system.h"

namespace grader::h5 {

// To the last bit, and in motion.
void root(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 6}) {
    const Strand strand = random_strand(random, n, 3);
    const VectorXd right = placed(random, strand, 0.3), x = disturbed(random, right, 0.05);
    for (int function : {kRelax, kCorrect}) {
      trial.describe(name_of(function) + ", the root");
      const VectorXd after = correct(trial, function, strand, x, 1e-6, kMostSweeps).result;
      trial.expect(after.head<3>() == x.head<3>(), name_of(function) + " moves the root");
      trial.expect(after != x, name_of(function) + " does nothing");
    }
    trial.describe("correct_velocities, the root");
    const VectorXd v = random_vector(random, 3 * n);
    const VectorXd after = correct_velocities(trial, strand, right, v, 1e-6).result;
    trial.expect(after.head<3>() == v.head<3>(), "correct_velocities changes the root's velocity");
    trial.expect(after != v, "correct_velocities does nothing");
  }
}

// The report is true: of the x that came back, of whether it is good enough, of how many iterations it took.
void report(Trial& trial) {
  Random& random = trial.random;
  for (int function : {kRelax, kCorrect}) {
    const std::string name = name_of(function);
    trial.describe(name + ", reports");
    const Strand strand = random_strand(random, 12, 1);
    const VectorXd right = placed(random, strand, 0.3), x = disturbed(random, right, 0.05);
    const double round = rounding(x, strand.rest_length.minCoeff());

    const Corrected nothing = correct(trial, function, strand, right, 1e-9, 100);
    trial.expect(nothing.result == right && nothing.report.iterations == 0 && nothing.report.converged,
                 name + " works on a strand that is right");
    const Corrected none = correct(trial, function, strand, x, 1e-9, 0);
    trial.expect(none.result == x && none.report.iterations == 0 && !none.report.converged,
                 name + " does something when it may take no iterations");
    trial.expect_at_most(std::abs(none.report.error - largest_error(strand, x)), round,
                         "the error of the error that " + name + " reports");

    const Corrected all = correct(trial, function, strand, x, 1e-9, kMostSweeps);
    trial.expect(all.report.converged && all.report.iterations > 0,
                 name + " takes no iterations, or does not converge", std::to_string(all.report.iterations));
    expect_near(trial, function, strand, x, all.result);
    const int most = all.report.iterations;
    const Corrected same = correct(trial, function, strand, x, 1e-9, most);
    trial.expect(same.result == all.result && same.report.iterations == most,
                 name + " does something else when it may take just the iterations that it needs");
    const Corrected fewer = correct(trial, function, strand, x, 1e-9, most - 1);
    trial.expect(!fewer.report.converged && fewer.report.iterations == most - 1,
                 name + " needs fewer iterations than it reports", std::to_string(most));
    for (const Corrected& corrected : {all, fewer})
      trial.expect_at_most(std::abs(corrected.report.error - largest_error(strand, corrected.result)), round,
                           "the error of the error that " + name + " reports");
  }
}

}  // namespace grader::h5
