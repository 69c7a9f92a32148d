// solver.json: the solver's study as programs read it.
//
//   program, format, quick, machine, seconds, left_out (null, or why there are no normal equations)
//   convergence, time   histories: system, solver, unknowns, condition, and progress: iterations, products, error (in the
//                       A-norm, relative to the first guess), squared_residual and claimed (relative to ||b||^2), seconds
//                       (null: not timed)
//   direct              system, solver, error, squared_residual, factor_seconds, solve_seconds
//   iterations          condition, conj_grad, eigen, clustered, normal_equations (null: not reached), bound
//   digits              condition, relative errors conj_grad, cholesky, qr, pivoted_qr (null: none), iterations
//   products            unknowns; of formula and table: multiplications, bytes, seconds
#pragma once

#include <string>
#include <string_view>

#include "solver/study/solver_study.h"

namespace hair {

inline constexpr std::string_view kSolverRecordBegin = "{\n  \"program\": \"hairlab solver\"";

std::string solver_json(const solver::study::SolverStudy& study, const std::string& machine,
                        const std::string& left_out);

}  // namespace hair
