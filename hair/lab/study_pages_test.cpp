// The sentences of the pages of solver, bowl and phase follow from the numbers, whatever the studied code
// does.

#include <gtest/gtest.h>

#include <cmath>

#include "hair/lab/bowl/bowl_page.h"
#include "hair/lab/phase/phase_plane.h"
#include "hair/lab/solver/solver_record.h"
#include "solver/test_refusal.h"

namespace hair {

using namespace solver_lab;
namespace {

using namespace solver::study;

History history(const std::string& system, const std::string& solver, double condition,
                const std::vector<double>& errors) {
  History all = {system, solver, 90, condition, {}};
  int k = 0;
  for (const double error : errors) {
    ++k;
    all.progress.push_back({k, k, k + 1, error, error * error, error * error, 1e-6 * k});
  }
  return all;
}

Compared compared(const std::string& system, const std::vector<double>& errors) {
  return {history(system, "ConjGrad", 100, errors), history(system, "Eigen's CG", 100, {0.1, 1e-11}), {}};
}

TEST(SolverVerdicts, AnErrorAboveTheBoundIsNamed) {
  // 2 (9/11)^m: 1.64 after one iteration, 1.34 after two.
  EXPECT_EQ(bound_verdict({compared("condition 100", {1.6, 1.3, 1e-16})}),
            "ConjGrad's errors are all below the bound.");
  const std::string above = "ConjGrad's errors are above the bound, where theory has none: ";
  EXPECT_EQ(bound_verdict({compared("a", {1.6}), compared("b", {1.6, 1.4}), compared("c", {std::nan("")})}),
            above + "b (1 of 2 points) and c (1 of 1 points).");
  EXPECT_EQ(bound_verdict({compared("rounding", std::vector<double>(300, 5e-10))}),
            "ConjGrad's errors are all below the bound.");
}

TEST(SolverVerdicts, TimesAreThoseThatWereMeasured) {
  Compared strand = compared("strand, h = 1 ms", {0.5, 0.4});
  strand.direct = {"strand, h = 1 ms", "banded Cholesky", 1e-16, 1e-32, 3e-6, 1e-6};
  EXPECT_EQ(time_verdict({compared("condition 100", {0.5, 1e-10}), strand}),
            "To an error of 1e-10, with condition 100: ConjGrad 2 \u00B5s, Eigen's CG 2 \u00B5s; with h = 1 "
            "ms: ConjGrad does not get there, Eigen's CG 2 \u00B5s, banded Cholesky 4 \u00B5s.");
}

TEST(SolverVerdicts, MoreIterationsThanTheBoundAndNoneAtAllAreNamed) {
  const IterationsNeeded good = {10, 27, 26, 5, 76, 33}, slow = {100, 200, 80, 5, 76, 120},
                         none = {1000, {}, 180, 5, 76, 400};
  EXPECT_EQ(needed_verdict({good}),
            "ConjGrad takes no more than that anywhere. At 10 it takes 27 iterations, Eigen's 26.");
  EXPECT_EQ(needed_verdict({good, slow, none}),
            "ConjGrad takes more than that, or nothing that is true, at condition numbers of 100 and 1000. "
            "At 100 it takes 200 iterations, Eigen's 80.");
}

SolverStudy study_of(const Compared& on) {
  SolverStudy study;
  study.most_iterations = 4000;
  study.conditions = study.strands = {on, on, on};
  study.needed = {{10, {}, 27, {}, {}, 33}};
  study.digits = {{1e7, 0.042, 4000, true, 1e-4, 1e-10}};
  return study;
}

TEST(SolverPage, WhatWasStoppedIsNoPointOfTheCurve) {
  const std::string page = to_html(solver_page(study_of(compared("strand, h = 1 ms", {0.5, 1e-12})), ""));
  EXPECT_TRUE(tests::says(page, "stopped at 4000 iterations, with an error of 0.042"));
  EXPECT_TRUE(tests::says(page, "stopped after the 4000 iterations"));
  EXPECT_TRUE(tests::says(page, "not within 4000 iterations, or its residual or its count is not true"));
}

TEST(SolverPage, IsDrawnOfCodeThatDoesNothing) {
  Compared on = compared("strand, h = 1 ms", {1, std::nan("")});
  on.conj_grad.progress[0].iterations = 0;
  on.conj_grad.progress[1].iterations = -7;
  for (Progress& one : on.conj_grad.progress) one.products = 0;
  SolverStudy study = study_of(on);
  EXPECT_NO_THROW(to_html(solver_page(study, "")));
}

TEST(BowlPage, SaysAPathByItsPlaces) {
  BowlPath path = {"ConjGrad", 1, 0, 1, 1, {0, 0}, {3, 4}, {{3, 4}, {1, 0}, {0, 0}, {0, 0}}};
  EXPECT_EQ(bowl::path_verdict(path),
            "It begins at b, as it should. It is at the bottom after 2 steps; two unknowns take 2.");
  path.places = {{0, 5}, {1, 0}};
  EXPECT_EQ(bowl::path_verdict(path),
            "It does not begin at b, as it should. After 1 step its height is still 0.04 of the first "
            "guess's; two unknowns take 2 steps.");
  path.solver = "the normal equations";
  path.places = {{3, 4}, {std::nan(""), 0}};
  EXPECT_EQ(bowl::path_verdict(path), "It begins at A'b, as it should. After 1 step its x is not a number.");
}

TEST(BowlPage, IsDrawnOfCodeThatDoesNothing) {
  const BowlPath path = solver::study::symmetric_path(
      [](int, implicitMatrix*, double x[], double[], double, int*) { return x[0] = std::nan(""); });
  EXPECT_NO_THROW(to_html(bowl::bowl_page({path}, "")));
}

TEST(PhasePage, IsDrawnOfNumbersThatAreNone) {
  phase::Motion motion = {"midpoint", "It winds outwards.", 2, 1, 4, {{0.5, 0}, {std::nan(""), 1e300}}};
  EXPECT_NO_THROW(to_html(phase::phase_page({motion})));
}

}  // namespace
}  // namespace hair
