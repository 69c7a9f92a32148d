#include "hair/lab/solver/solver_record.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hair/io/plot/figure.h"

namespace hair::solver_lab {

namespace {

using namespace solver::study;

enum class Against { iterations, products, time };
enum class Measure { error, squared_residual };

constexpr double kZero = 1e-34;  // stands for an exact zero on a logarithmic axis

// A value that is not finite becomes a failed point; an exact zero is drawn low enough to stand out.
Point point(double x, double y, std::string note = {}) {
  Point p = {x, y, std::move(note)};
  if (!std::isfinite(y)) {
    p.failed = true;
    p.note += (p.note.empty() ? "" : ", ") + std::string("no solution");
  } else if (y < kZero) {
    p.y = kZero;
    p.note += (p.note.empty() ? "" : ", ") + std::string("as good as zero");
  }
  return p;
}

Series series_of(const History& history, const std::string& name, Against against, Measure measure) {
  Series series = {name, {}};
  for (const Progress& progress : history.progress) {
    const double x = against == Against::iterations ? std::max(1, progress.iterations)
                     : against == Against::products ? static_cast<double>(std::max(1L, progress.products))
                                                    : progress.seconds;
    series.points.push_back(point(x, measure == Measure::error ? progress.error : progress.squared_residual,
                                  std::to_string(progress.iterations) + " iterations, " +
                                      std::to_string(progress.products) + " products"));
  }
  return series;
}

// The theory's curve for a measured history, down to the history's last error; with the look of another
// series.
Series bound_of(const History& history, const std::string& name, int look) {
  Series series = {name, {}, true, false, true, look};
  for (const Progress& progress : history.progress) {
    const int iterations = std::max(1, progress.iterations);
    const double bound = error_bound(history.condition, iterations);
    if (bound < 1e-16) break;
    series.points.push_back({static_cast<double>(iterations), bound});
  }
  return series;
}

// The system's name in a legend.
std::string legend_of(const History& history) {
  return history.system.starts_with("strand") ? step_of(history.system)
                                              : "condition " + to_text(history.condition);
}

// ConjGrad on all systems; or all solvers, and the direct solve against time, on the first, the middle and
// the last system: all systems together would hide each other, and the tables have them.
enum class Drawn { conj_grad, all_solvers };

Figure figure_of(Drawn drawn, const std::vector<Compared>& systems, const std::string& id,
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
    const std::string name = legend_of(on.conj_grad);
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

Section conditions_section(const SolverStudy& study) {
  Figure error = figure_of(Drawn::conj_grad, study.conditions, "error-against-iterations",
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
      figure_of(Drawn::all_solvers, study.conditions, "squared-residual-against-iterations",
                "Squared residual against iterations",
                "Residuals should fall as errors do, but may grow on the way, and be small sooner.",
                Against::iterations, Measure::squared_residual);
  Figure time =
      figure_of(Drawn::all_solvers, study.conditions, "error-against-time", "Error against CPU time",
                "The time of so many iterations: as the curves against iterations, if each iteration takes "
                "as long as the others.",
                Against::time, Measure::error);
  return {"Condition numbers",
          {"Systems of " + std::to_string(kUnknowns) +
               " unknowns whose eigenvalues' logarithms are evenly spaced. The dashed curves are the "
               "theory's bound without rounding, 2 ((\u221Ac \u2212 1) / (\u221Ac + 1))\u1D50 for the "
               "condition number c: about \u221Ac / 2 iterations for each factor of e. " +
               bound_verdict(study.conditions),
           "The residual is what ConjGrad sees and ends by. The error is what one wants. In the A-norm it "
           "should shrink in each iteration; the residual may grow on the way, and be small long before the "
           "error is. Where rounding ends it, more iterations make nothing better, and some things worse.",
           "No banded Cholesky stands beside these, as it does beside the strand below: these matrices are "
           "full, diagonal ones that were reflected. Only their products are cheap. The band of a full "
           "matrix is all of it, and to eliminate takes n\u00B3/3 multiplications.",
           time_verdict(study.conditions)},
          {to_svg(error), to_svg(residual), to_svg(time)},
          tables_of(study.conditions, "Condition numbers")};
}

Section strands_section(const SolverStudy& study) {
  Figure products =
      figure_of(Drawn::conj_grad, study.strands, "strand-error-against-products",
                "Error of ConjGrad against products: a strand in steps of time",
                "The longer the step, the stiffer the system, the more products it should take.",
                Against::products, Measure::error);
  Figure residual = figure_of(Drawn::all_solvers, study.strands, "strand-squared-residual-against-iterations",
                              "Squared residual against iterations: a strand in steps of time",
                              "The longer the step, the more the residual may grow before it falls.",
                              Against::iterations, Measure::squared_residual);
  Figure time = figure_of(Drawn::all_solvers, study.strands, "strand-error-against-time",
                          "Error against CPU time: a strand in steps of time",
                          "Banded Cholesky is one point for each step: as much work for any of them.",
                          Against::time, Measure::error);

  const History& longest = study.strands.back().conj_grad;
  return {"A strand",
          {"M + h\u00B2K of a step of implicit Euler of a model of a hair: 30 cm in 30 segments, clamped, "
           "with springs EA/l along it and EI/l\u00B3 across it between neighbours; " +
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
           "springs is 8 wide, and the factor takes six times the multiplications. What it needs, too, is "
           "the matrix: the springs of a lone strand give it, links between strands and collisions spoil its "
           "band. ConjGrad needs nothing but products."},
          {to_svg(products), to_svg(residual), to_svg(time)},
          tables_of(study.strands, "ConjGrad and Eigen's ConjugateGradient on a strand")};
}

Section needed_section(const SolverStudy& study) {
  Figure figure = {"iterations-against-condition",
                   "Iterations against condition number",
                   "Iterations should grow with the square root of the condition number, those on A'A with "
                   "the condition number.",
                   {"condition number"},
                   {"iterations to a residual of 1e-8"},
                   {{"ConjGrad", {}},
                    {"Eigen's CG", {}},
                    {"ConjGrad, " + std::to_string(kNeededClusters) + " clusters", {}}},
                   {{0.5, "slope 1/2"}, {1, "slope 1"}}};
  Series normal = {"ConjGrad on A'A", {}}, bound = {"theory, at most", {}, true, false, true, 0};
  const auto add = [&](Series& series, double condition, const std::optional<int>& iterations) {
    Point p = {condition, static_cast<double>(std::max(1, iterations.value_or(1)))};
    p.failed = !iterations;
    if (p.failed)
      p.note = "condition " + to_text(condition) + ": not within " + std::to_string(study.most_iterations) +
               " iterations, or its residual or its count is not true";
    series.points.push_back(p);
  };
  for (const IterationsNeeded& one : study.needed) {
    add(figure.series[0], one.condition, one.conj_grad);
    add(figure.series[1], one.condition, one.eigen);
    add(figure.series[2], one.condition, one.clustered);
    if (!study.digits.empty()) add(normal, one.condition, one.normal_equations);
    bound.points.push_back({one.condition, one.bound});
  }
  if (!normal.points.empty()) figure.series.push_back(normal);
  figure.series.push_back(bound);
  std::vector<std::string> paragraphs = {
      "How many iterations it takes until the residual is 1e-8 of the right-hand side, " +
          std::to_string(kUnknowns) + " unknowns. The bound is sqrt(c) / 2 log(2 sqrt(c) / 1e-8). " +
          needed_verdict(study.needed),
      "Eigen's ConjugateGradient does not put the true residual in the recurrence's place each 64 "
      "iterations, as ConjGrad should. To put it there is safer, and where the condition number is large it "
      "takes more iterations: directions that were conjugate no longer quite are."};
  if (!normal.points.empty())
    paragraphs.push_back(
        "On A'A, whose condition number is c\u00B2, the slope should be 1 at first. If fewer are needed "
        "further on, that is no good news: there a residual of 1e-8 is reached before x has moved along the "
        "small eigenvalues' directions at all.");
  return {"How many iterations",
          paragraphs,
          {to_svg(figure)},
          {table_of(rows_of(study.needed, row_of_needed),
                    "Iterations until the residual is 1e-8 of the right-hand side (empty: not within the "
                    "limit, or the solver's residual or count is not true)")}};
}

Section digits_section(const SolverStudy& study) {
  Figure figure = {
      "error-against-condition",
      "Digits lost: the normal equations beside QR",
      "Errors of QR should grow with the condition number, those of the normal equations with its square.",
      {"condition number of A"},
      {"relative error of x (a decade is a digit)"},
      {{"ConjGrad on A'A", {}}, {"Cholesky of A'A", {}}, {"QR of A", {}}},
      {}};
  Series square = {"u c\u00B2", {}, true, false, true, 1}, linear = {"u c", {}, true, false, true, 2};
  for (const DigitsLost& one : study.digits) {
    const std::string at = "condition " + to_text(one.condition);
    Point normal =
        point(one.condition, one.conj_grad,
              at + (one.stopped ? ": stopped at " : ", ") + std::to_string(one.iterations) + " iterations");
    if (one.stopped && !normal.failed) {
      normal.failed = true;
      normal.note += ", with an error of " + to_text(one.conj_grad);
    }
    figure.series[0].points.push_back(normal);
    figure.series[1].points.push_back(point(one.condition, one.cholesky, at));
    figure.series[2].points.push_back(point(one.condition, one.qr));
    if (kRounding * one.condition * one.condition <= 10)
      square.points.push_back({one.condition, kRounding * one.condition * one.condition});
    linear.points.push_back({one.condition, kRounding * one.condition});
  }
  figure.series.push_back(square);
  figure.series.push_back(linear);
  Section section = {
      "Normal equations, and the digits that they cost",
      {"Systems of " + std::to_string(kDigitsUnknowns) +
       " unknowns that are not symmetric, singular values from 1/c to 1. A'A x = A'b has the condition "
       "number c\u00B2: it should lose two digits where QR, which works on A itself, loses one. Beyond c = "
       "1e8, the square root of 1/u (u = 1.1e-16), A'A says nothing about x any more: Cholesky finds that it "
       "is not positive definite, and ConjGrad ends with an error as large as x."},
      {to_svg(figure)},
      {table_of(rows_of(study.digits, row_of_digits),
                "Relative errors of x, and digits that are left of 16")}};
  if (const std::string stopped = stopped_verdict(study.digits); !stopped.empty())
    section.paragraphs.push_back(stopped);
  return section;
}

}  // namespace

Page solver_page(const SolverStudy& study, const std::string& left_out) {
  Page page = {"A study of the solver",
               {"What ConjGrad and the normal equations do, beside Eigen's ConjugateGradient, banded "
                "Cholesky and QR. Times are CPU time, medians of repeats."},
               {}};
  if (!left_out.empty()) page.paragraphs.push_back("The normal equations are left out: " + left_out + ".");
  page.sections = {conditions_section(study), strands_section(study), needed_section(study)};
  if (!study.digits.empty()) page.sections.push_back(digits_section(study));
  return page;
}

}  // namespace hair::solver_lab
