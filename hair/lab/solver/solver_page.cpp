#include "hair/lab/solver/solver_record.h"

#include <algorithm>
#include <cmath>

#include "hair/io/plot/figure.h"
#include "hair/lab/solver/solver_series.h"
#include "hair/lab/solver/solver_verdicts.h"

namespace hair::solver_lab {

namespace {

using namespace solver::study;

Section needed_section(const SolverStudy& study) {
  Figure figure = {
      "iterations-against-condition",
      "Iterations against condition number",
      "Iterations should grow with the square root of the condition number, those on A'A with the condition "
      "number.",
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
      "iterations, "
      "as ConjGrad should. To put it there is safer, and where the condition number is large it takes more "
      "iterations: directions that were conjugate no longer quite are."};
  if (!normal.points.empty())
    paragraphs.push_back(
        "On A'A, whose condition number is c\u00B2, the slope should be 1 at first. If fewer are needed "
        "further on, that is no good news: there a residual of 1e-8 is reached before x has moved along the "
        "small eigenvalues' directions at all.");
  return {"How many iterations",
          paragraphs,
          {to_svg(figure)},
          {table_of(
              rows_of(study.needed, row_of_needed),
              "Iterations until the residual is 1e-8 of the right-hand side (empty: not within the limit, or "
              "the solver's residual or count is not true)")}};
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
       "number "
       "c\u00B2: it should lose two digits where QR, which works on A itself, loses one. Beyond c = 1e8, the "
       "square root of 1/u (u = 1.1e-16), A'A says nothing about x any more: Cholesky finds that it is not "
       "positive definite, and ConjGrad ends with an error as large as x."},
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
