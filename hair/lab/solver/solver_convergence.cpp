#include "hair/lab/solver/solver_series.h"

#include <string>
#include <vector>

#include "hair/io/plot/figure.h"
#include "hair/lab/solver/solver_record.h"
#include "hair/lab/solver/solver_verdicts.h"

namespace hair::solver_lab {

namespace {

using namespace solver::study;

// Gives a history its name in a legend.
using Named = std::string (*)(const History&);

std::string step_name(const History& history) {
  return step_of(history.system);
}

// ConjGrad on all systems; or all solvers, and the direct solve against time, on the first, the middle and
// the last system: all systems together would hide each other, and the tables have them.
enum class Drawn { conj_grad, all_solvers };

Figure figure_of(Drawn drawn, const std::vector<Compared>& systems, Named named, const std::string& id,
                 const std::string& title, const std::string& description, Against against, Measure measure) {
  Figure figure = {id,
                   title,
                   description,
                   {against == Against::iterations ? "iterations"
                    : against == Against::products ? "products with A"
                                                   : "CPU time, s"},
                   {measure == Measure::error ? "error in the A-norm, relative to the first guess"
                                              : "\u2016b \u2212 Ax\u2016\u00B2 / \u2016b\u2016\u00B2"}};
  const std::size_t last = systems.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const Compared& on = systems[i];
    const std::string name = named(on.conj_grad);
    if (drawn == Drawn::conj_grad)
      figure.series.push_back(series_of(on.conj_grad, name, against, measure));
    else if (i == 0 || i == systems.size() / 2 || i == last) {
      for (const History* history : on.histories())
        figure.series.push_back(series_of(*history, history->solver + ", " + name, against, measure));
      if (on.direct && against == Against::time)
        figure.series.push_back(
            {on.direct->solver + ", " + name,
             {point(on.direct->factor_seconds + on.direct->solve_seconds,
                    measure == Measure::error ? on.direct->error : on.direct->squared_residual)},
             false});
    }
  }
  return figure;
}

// The tables have all solvers, and the direct solve if there is one.
std::vector<Table> tables_of(const std::vector<Compared>& systems, const std::string& caption) {
  std::vector<Table> tables = {table_of(convergence_rows(systems), caption)};
  add_table(tables, direct_rows(systems), "A direct way on the same systems");
  return tables;
}

}  // namespace

Section conditions_section(const SolverStudy& study) {
  Figure error = figure_of(Drawn::conj_grad, study.conditions, condition_name, "error-against-iterations",
                           "Error of ConjGrad against iterations",
                           "The larger the condition number, the more iterations; all curves should stay "
                           "below the theory's bound until rounding ends them. " +
                               bound_verdict(study.conditions),
                           Against::iterations, Measure::error);
  for (std::size_t i = 0; i < study.conditions.size(); ++i) {
    const History& history = study.conditions[i].conj_grad;
    error.series.push_back(bound_of(history, "bound, " + to_text(history.condition), static_cast<int>(i)));
  }
  Figure residual =
      figure_of(Drawn::all_solvers, study.conditions, condition_name, "squared-residual-against-iterations",
                "Squared residual against iterations",
                "Residuals should fall as errors do, but may grow on the way, and be small sooner.",
                Against::iterations, Measure::squared_residual);
  Figure time = figure_of(Drawn::all_solvers, study.conditions, condition_name, "error-against-time",
                          "Error against CPU time",
                          "The time of so many iterations: as the curves against iterations, if each "
                          "iteration takes as long as the others.",
                          Against::time, Measure::error);
  return {
      "Condition numbers",
      {"Systems of " + std::to_string(kUnknowns) +
           " unknowns whose eigenvalues' logarithms are evenly spaced. The dashed curves are the theory's "
           "bound without rounding, 2 ((\u221Ac \u2212 1) / (\u221Ac + 1))\u1D50 for the condition number "
           "c: about \u221Ac / 2 iterations for each factor of e. " +
           bound_verdict(study.conditions),
       "The residual is what ConjGrad sees and ends by. The error is what one wants. In the A-norm it "
       "should shrink in each iteration; the residual may grow on the way, and be small long before the "
       "error is. Where rounding ends it, more iterations make nothing better, and some things worse.",
       "No banded Cholesky stands beside these, as it does beside the strand below: these matrices are "
       "full, diagonal ones that were reflected. Only their products are cheap. The band of a full matrix "
       "is all of it, and to eliminate takes n\u00B3/3 multiplications.",
       time_verdict(study.conditions)},
      {to_svg(error), to_svg(residual), to_svg(time)},
      tables_of(study.conditions, "Condition numbers")};
}

Section strands_section(const SolverStudy& study) {
  Figure products =
      figure_of(Drawn::conj_grad, study.strands, step_name, "strand-error-against-products",
                "Error of ConjGrad against products: a strand in steps of time",
                "The longer the step, the stiffer the system, the more products it should take.",
                Against::products, Measure::error);
  Figure residual =
      figure_of(Drawn::all_solvers, study.strands, step_name, "strand-squared-residual-against-iterations",
                "Squared residual against iterations: a strand in steps of time",
                "The longer the step, the more the residual may grow before it falls.", Against::iterations,
                Measure::squared_residual);
  Figure time = figure_of(Drawn::all_solvers, study.strands, step_name, "strand-error-against-time",
                          "Error against CPU time: a strand in steps of time",
                          "Banded Cholesky is one point for each step: as much work for any of them.",
                          Against::time, Measure::error);

  const History& longest = study.strands.back().conj_grad;
  return {
      "A strand",
      {"M + h\u00B2K of a step of implicit Euler of a model of a hair: 30 cm in 30 segments, clamped, with "
       "springs EA/l along it and EI/l\u00B3 across it between neighbours; " +
           std::to_string(longest.n) +
           " unknowns. Its condition number grows with the square of the step h: " +
           to_text(longest.condition) + " for " + step_of(longest.system) +
           ". But along and across the strand there are only " + std::to_string(2 * longest.n / 3) +
           " different eigenvalues in all: without rounding ConjGrad would need no more iterations than "
           "that.",
       "The matrix is banded, 3 below the diagonal. So there is a direct way: banded Cholesky, O(n), "
       "whatever the condition number. " +
           time_verdict(study.strands),
       "The model is kind to it. Bending as in H2 reaches two particles far: the band of H1's and H2's "
       "springs is 8 wide, and the factor takes six times the multiplications. What it needs, too, is the "
       "matrix: the springs of a lone strand give it, links between strands and collisions spoil its band. "
       "ConjGrad needs nothing but products."},
      {to_svg(products), to_svg(residual), to_svg(time)},
      tables_of(study.strands, "ConjGrad and Eigen's ConjugateGradient on a strand")};
}

}  // namespace hair::solver_lab
