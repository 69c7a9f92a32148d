// STAFF ONLY. Tests that the page of costs puts the most expensive first, compared with the reference.
#include "grader/report/pages/pages.h"

#include <gtest/gtest.h>

#include <string>

#include "grader/report/facts/sample_results.h"
#include "hair/io/plot/test_parsed.h"

namespace grader::inline report {
namespace {

ExerciseTiming seconds(double compile, double suite) {
  return {.compile_seconds = compile, .suite_seconds = suite, .worker_cpu_seconds = 900};
}

ClassCosts three_submissions() {
  ClassCosts costs;
  costs.reference = {{"S1", seconds(0, 0.5)}, {"H4", seconds(0, 0.75)}};
  costs.submissions["alice"] = {{"S1", seconds(1, 1)}, {"H4", seconds(0, 1)}};
  costs.submissions["bob"] = {{"S1", seconds(0, 2)}, {"H4", seconds(3, 5)}};
  costs.submissions["carol"] = {};
  return costs;
}

TEST(CostsPage, ShowsTheMostExpensiveFirst) {
  const std::string page = costs_page(three_submissions());
  expect_in_order(page, {"<strong>13</strong> seconds by the clock for 3 submissions, 1.25 for the reference",
                         "id=\"parts\"", ">H4<", ">4.50<", ">0.75<", "69 %", ">S1<", "id=\"submissions\"",
                         "data-sort=\"number\"", "staff/bob.html", ">10.00<", "H4, 80 %", "staff/alice.html",
                         ">3.00<", "S1, 67 %", "staff/carol.html", ">0.00<"});
}

TEST(CostsPage, AStrictParserReadsItWithoutAnybody) {
  EXPECT_NO_THROW(hair::plot::parse(costs_page(three_submissions(), {{"bob", "Bob <b>"}})));
  EXPECT_NO_THROW(hair::plot::parse(costs_page({})));
}

}  // namespace
}  // namespace grader::report
