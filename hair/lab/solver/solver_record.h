// The solver's study: solver.json, the rows of its CSV files and of the page's tables, the page, and its
// sentences. In solver.json:
//
//   program, quick, machine, format, seconds, left_out (null, or why there are no normal equations)
//   convergence         histories: family, system, solver, unknowns, condition, and progress: iterations,
//                       products, error (in the A-norm, relative to the first guess), squared_residual and
//                       claimed (relative to ||b||^2; null for Eigen's, which does not report it), seconds
//   direct              system, solver, error, squared_residual, factor_seconds, solve_seconds
//   iterations          condition, conj_grad, eigen, clustered, normal_equations (null: not within
//                       most_iterations, or a false residual or count), bound
//   digits              condition, relative errors conj_grad, cholesky, qr (null: none),
//                       iterations, stopped (whether conj_grad used all allowed iterations)
#pragma once

#include <string>
#include <vector>

#include "hair/io/plot/columns.h"
#include "solver/study/solver_study.h"

namespace hair::solver_lab {

// `left_out` is the reason why there are no normal equations, or empty.
OrderedJson solver_json(const solver::study::SolverStudy& study, const std::string& left_out);
Page solver_page(const solver::study::SolverStudy& study, const std::string& left_out);

Row row_of_needed(const solver::study::IterationsNeeded& needed);
Row row_of_digits(const solver::study::DigitsLost& digits);

// The rows of all systems have a history's columns, then those of its progress; and the direct solves.
std::vector<Row> convergence_rows(const std::vector<solver::study::Compared>& systems);
std::vector<Row> direct_rows(const std::vector<solver::study::Compared>& systems);

// ---- The conclusions, as sentences ----
//
// The numbers decide each sentence, because the studied code may be wrong.

// Compares ConjGrad's errors with the theory's bound, as long as they are well above rounding.
std::string bound_verdict(const std::vector<solver::study::Compared>& systems);

// The times of ConjGrad, Eigen's conjugate gradients and the direct solver on the first and the last system.
std::string time_verdict(const std::vector<solver::study::Compared>& systems);

// Names systems for which ConjGrad took more iterations than the bound, compared with Eigen's.
std::string needed_verdict(const std::vector<solver::study::IterationsNeeded>& needed);

// Names systems for which the normal equations used all iterations; empty if there are none.
std::string stopped_verdict(const std::vector<solver::study::DigitsLost>& digits);

// "h = 10 ms" of "strand, h = 10 ms".
std::string step_of(const std::string& system);

}  // namespace hair::solver_lab
