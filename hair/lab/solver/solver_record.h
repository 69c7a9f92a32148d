// solver.json: the solver study in machine-readable form.
//
//   program, format, quick, machine, seconds, left_out (null, or why there are no normal equations)
//   convergence         histories: family, system, solver, unknowns, condition, and progress: iterations,
//                       products, error (in the A-norm, relative to the first guess), squared_residual and
//                       claimed (relative to ||b||^2; null for Eigen's, which does not report it), seconds
//   direct              system, solver, error, squared_residual, factor_seconds, solve_seconds
//   iterations          condition, conj_grad, eigen, clustered, normal_equations (null: not within
//                       most_iterations, or a false residual or count), bound
//   digits              condition, relative errors conj_grad, cholesky, qr, pivoted_qr (null: none),
//                       iterations, stopped (whether conj_grad used all allowed iterations)
//   products            unknowns; of formula and table: multiplications, bytes, seconds
#pragma once

#include <string>
#include <string_view>

#include "solver/study/solver_study.h"

namespace hair::solver_lab {

inline constexpr std::string_view kSolverRecordBegin = "{\n  \"program\": \"hairlab solver\"";

std::string solver_json(const solver::study::SolverStudy& study, const std::string& machine,
                        const std::string& left_out);

}  // namespace hair::solver_lab
