// solver.json: the solver's study as programs read it.
//
//   program, format, quick, machine, seconds, left_out (null, or why there are no normal equations)
//   convergence         histories: family, system, solver, unknowns, condition, and progress: iterations, products, error
//                       (in the A-norm, relative to the first guess), squared_residual and claimed (relative to ||b||^2;
//                       null: Eigen's does not say), seconds
//   direct              system, solver, error, squared_residual, factor_seconds, solve_seconds
//   iterations          condition, conj_grad, eigen, clustered, normal_equations (null: not within most_iterations, or the
//                       residual or the count is not true), bound
//   digits              condition, relative errors conj_grad, cholesky, qr, pivoted_qr (null: none), iterations, stopped
//                       (whether they were all that conj_grad may take)
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
