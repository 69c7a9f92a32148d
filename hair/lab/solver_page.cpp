#include "hair/lab/solver_page.h"

#include <algorithm>
#include <cmath>

#include "hair/lab/solver_series.h"
#include "hair/lab/solver_tables.h"
#include "hair/plot/figure.h"

namespace hair {

namespace {

using namespace solver::study;

Section conditions_section(const SolverStudy& study) {
  Figure error = {
      "error-against-iterations",
      "Error of ConjGrad against iterations",
      "The larger the condition number, the more iterations; all curves stay below the theory's bound "
      "until rounding ends them.",
      {"iterations"},
      {"error in the A-norm, relative to the first guess"},
      {},
      {}};
  Figure residual = {"squared-residual-against-iterations",
                     "Squared residual of ConjGrad against iterations",
                     "Residuals fall as errors do, but not in each iteration, and sooner.",
                     {"iterations"},
                     {"\u2016b \u2212 Ax\u2016\u00B2 / \u2016b\u2016\u00B2"},
                     {},
                     {}};
  for (const History& history : study.conditions) {
    error.series.push_back(series_of(history, condition_name(history), Against::iterations, Measure::error));
    residual.series.push_back(
        series_of(history, condition_name(history), Against::iterations, Measure::squared_residual));
  }
  for (std::size_t i = 0; i < study.conditions.size(); ++i)
    error.series.push_back(bound_of(study.conditions[i], "bound, " + to_text(study.conditions[i].condition),
                                    static_cast<int>(i)));
  return {"Condition numbers",
          {"Systems of " + std::to_string(kUnknowns) +
               " unknowns whose eigenvalues' logarithms are evenly spaced. The dashed curves are the "
               "theory's bound "
               "without rounding, 2 ((\u221Ac \u2212 1) / (\u221Ac + 1))\u1D50 for the condition number c: "
               "about \u221Ac / 2 "
               "iterations for each factor of e.",
           "The residual is what ConjGrad sees and ends by. The error is what one wants. In the A-norm it "
           "shrinks in each "
           "iteration; the residual may grow on the way, and be small long before the error is. Where "
           "rounding ends it, more "
           "iterations make nothing better, and some things worse."},
          {to_svg(error), to_svg(residual)},
          {table_of("Condition numbers", study.conditions, to_text)}};
}

Section clusters_section(const SolverStudy& study) {
  Figure figure = {"error-for-clusters",
                   "Error of ConjGrad against iterations: clustered eigenvalues",
                   "With k different eigenvalues the error drops to rounding after k iterations.",
                   {"iterations"},
                   {"error in the A-norm, relative to the first guess"},
                   {},
                   {}};
  for (const History& history : study.clusters)
    figure.series.push_back(series_of(history, history.system, Against::iterations, Measure::error));
  return {"Clustered eigenvalues",
          {"The condition number is " + to_text(study.clusters.front().condition) +
           " for all of them, and the bound above the same. But what counts is how many different "
           "eigenvalues there are: "
           "without rounding, k of them take k iterations. A good preconditioner does not only lower the "
           "condition number; "
           "it draws eigenvalues together."},
          {to_svg(figure)},
          {table_of("Clustered eigenvalues", study.clusters, to_text)}};
}

// "h = 10 ms" of "strand, h = 10 ms".
std::string step_of(const std::string& system) {
  const std::size_t at = system.find("h = ");
  return at == std::string::npos ? system : system.substr(at);
}

// Seconds until the error first is below `error`; none: never.
std::optional<double> seconds_to(const History& history, double error) {
  for (const Progress& progress : history.progress)
    if (progress.error <= error) return progress.seconds;
  return std::nullopt;
}

std::string verdict(const SolverStudy& study) {
  constexpr double kGood = 1e-10;
  std::string text;
  for (const DirectSolve& direct : study.direct)
    for (const History& history : study.timed) {
      if (history.system != direct.system || history.solver != "ConjGrad") continue;
      const auto seconds = seconds_to(history, kGood);
      text += (text.empty() ? "With " : " With ") + step_of(direct.system) + " banded Cholesky takes " +
              to_text(1e6 * (direct.factor_seconds + direct.solve_seconds)) + " \u00B5s, ConjGrad " +
              (seconds ? to_text(1e6 * *seconds) + " \u00B5s to an error of " + to_text(kGood)
                       : "does not reach an error of " + to_text(kGood)) +
              ".";
    }
  return text;
}

Section strands_section(const SolverStudy& study) {
  Figure products = {"strand-error-against-products",
                     "Error of ConjGrad against products: a strand in steps of time",
                     "The longer the step, the stiffer the system, the more products.",
                     {"products with A"},
                     {"error in the A-norm, relative to the first guess"},
                     {},
                     {}};
  for (const History& history : study.strands)
    products.series.push_back(series_of(history, step_of(history.system), Against::products, Measure::error));

  Figure time = {"strand-error-against-time",
                 "Error against CPU time: a strand in steps of time",
                 "Banded Cholesky is at rounding in the time of a few iterations of conjugate gradients.",
                 {"CPU time, s"},
                 {"error in the A-norm, relative to the first guess"},
                 {},
                 {}};
  for (const History& history : study.timed)
    time.series.push_back(
        series_of(history, history.solver + ", " + step_of(history.system), Against::time, Measure::error));
  for (const DirectSolve& direct : study.direct)
    time.series.push_back({direct.solver + ", " + step_of(direct.system),
                           {point(direct.factor_seconds + direct.solve_seconds, direct.error)},
                           false});

  const History& longest = study.strands.back();
  return {"A strand",
          {"M + h\u00B2K of a step of implicit Euler: human hair, 30 cm in 30 segments, clamped; " +
               std::to_string(longest.n) +
               " unknowns. Its condition number grows with the square of the step h: " +
               to_text(longest.condition) + " for " + step_of(longest.system) +
               ". But along and across the strand there are only 60 different eigenvalues in all: without "
               "rounding ConjGrad would "
               "need no more iterations than that.",
           "The matrix is banded, 3 below the diagonal. So there is a direct way: banded Cholesky, O(n), "
           "whatever the condition "
           "number. " +
               verdict(study) +
               " What it needs is the matrix: the springs of a lone strand give it, links between strands "
               "and collisions "
               "spoil its band. ConjGrad needs nothing but products."},
          {to_svg(products), to_svg(time)},
          {table_of("ConjGrad on a strand", study.strands, to_text),
           table_of("ConjGrad and Eigen's ConjugateGradient, timed", study.timed, to_text),
           table_of(study.direct, to_text)}};
}

Section needed_section(const SolverStudy& study) {
  Figure figure = {
      "iterations-against-condition",
      "Iterations against condition number",
      "Iterations grow with the square root of the condition number, those on A'A with the condition number.",
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
               " iterations";
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
          std::to_string(kUnknowns) +
          " unknowns. The bound is sqrt(c) / 2 log(2 sqrt(c) / 1e-8): ConjGrad stays below it, with the same "
          "slope as long as "
          "there are more eigenvalues than iterations.",
      "Eigen's ConjugateGradient does the same without putting the true residual in the recurrence's place "
      "each 64 iterations. "
      "That is safer, and where the condition number is large it takes more iterations: directions that were "
      "conjugate no longer "
      "quite are."};
  if (!normal.points.empty())
    paragraphs.push_back(
        "On A'A, whose condition number is c\u00B2, the slope is 1 at first. That fewer are needed further "
        "on is no good "
        "news: there a residual of 1e-8 is reached before x has moved along the small eigenvalues' "
        "directions at all.");
  return {"How many iterations", paragraphs, {to_svg(figure)}, {table_of(study.needed, to_text)}};
}

Section digits_section(const SolverStudy& study) {
  Figure figure = {
      "error-against-condition",
      "Digits lost: the normal equations beside QR",
      "Errors of QR grow with the condition number, those of the normal equations with its square.",
      {"condition number of A"},
      {"relative error of x (a decade is a digit)"},
      {{"ConjGrad on A'A", {}}, {"Cholesky of A'A", {}}, {"QR of A", {}}, {"QR of A with pivots", {}}},
      {}};
  Series square = {"u c\u00B2", {}, true, false, true, 1}, linear = {"u c", {}, true, false, true, 2};
  for (const DigitsLost& one : study.digits) {
    const std::string at = "condition " + to_text(one.condition);
    figure.series[0].points.push_back(
        point(one.condition, one.conj_grad, at + ", " + std::to_string(one.iterations) + " iterations"));
    figure.series[1].points.push_back(point(one.condition, one.cholesky, at));
    figure.series[2].points.push_back(point(one.condition, one.qr));
    figure.series[3].points.push_back(point(one.condition, one.pivoted_qr));
    if (kRounding * one.condition * one.condition <= 10)
      square.points.push_back({one.condition, kRounding * one.condition * one.condition});
    linear.points.push_back({one.condition, kRounding * one.condition});
  }
  figure.series.push_back(square);
  figure.series.push_back(linear);
  return {"Normal equations, and the digits that they cost",
          {"Systems of " + std::to_string(kDigitsUnknowns) +
               " unknowns that are not symmetric, singular values from 1/c to 1. A'A x = A'b has the "
               "condition number "
               "c\u00B2: it loses two digits where QR, which works on A itself, loses one. Beyond c = 1e8, "
               "the square root "
               "of 1/u (u = 1.1e-16), A'A says nothing about x any more: Cholesky finds that it is not "
               "positive definite, and "
               "ConjGrad ends with an error as large as x.",
           "Before that, ConjGrad on A'A runs out of iterations: it may take " +
               std::to_string(study.most_iterations) + " of them here."},
          {to_svg(figure)},
          {table_of(study.digits, to_text)}};
}

Section products_section(const SolverStudy& study) {
  Figure figure = {"product-cost",
                   "Why implicitMatrix? A product's time, and the matrix' memory",
                   "By its formula a product takes time and memory in proportion to n, by the table of "
                   "entries to n squared.",
                   {"unknowns n"},
                   {"nanoseconds; bytes"},
                   {{"table: bytes", {}, true, true, true},
                    {"table: ns a product", {}},
                    {"formula: bytes", {}, true, true, true},
                    {"formula: ns a product", {}}},
                   {{1, "slope 1"}, {2, "slope 2"}}};
  for (const ProductCost& one : study.products) {
    const auto add = [&](std::size_t series, double y, const std::string& note) {
      figure.series[series].points.push_back(point(one.n, y, note));
    };
    add(0, static_cast<double>(one.table.bytes), "");
    add(1, 1e9 * one.table.seconds, std::to_string(one.table.multiplications) + " multiplications");
    add(2, static_cast<double>(one.formula.bytes), "");
    add(3, 1e9 * one.formula.seconds, std::to_string(one.formula.multiplications) + " multiplications");
  }
  const ProductCost& last = study.products.back();
  return {"Why implicitMatrix?",
          {"A product with a strand's matrix: by its formula, three numbers for each particle and three "
           "multiplications for "
           "each unknown; and by the table of all entries. With " +
           std::to_string(last.n) + " unknowns the table takes " +
           to_text(last.table.seconds / last.formula.seconds) + " times as long, and " +
           to_text(static_cast<double>(last.table.bytes) / static_cast<double>(last.formula.bytes)) +
           " times the memory, nearly all of it for zeros."},
          {to_svg(figure)},
          {table_of(study.products, to_text)}};
}

}  // namespace

Page solver_page(const SolverStudy& study, const std::string& machine, const std::string& left_out) {
  Page page = {"A study of the solver",
               {"What ConjGrad and the normal equations do, beside Eigen's ConjugateGradient, banded "
                "Cholesky and QR. Times "
                "are CPU time, medians of repeats. " +
                    std::string(study.quick ? "A quick study: fewer points, and shorter repeats." : ""),
                machine},
               {}};
  if (!left_out.empty()) page.paragraphs.push_back("The normal equations are left out: " + left_out + ".");
  page.sections = {conditions_section(study), clusters_section(study), strands_section(study),
                   needed_section(study)};
  if (!study.digits.empty()) page.sections.push_back(digits_section(study));
  page.sections.push_back(products_section(study));
  return page;
}

}  // namespace hair
