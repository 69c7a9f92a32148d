// STAFF ONLY. Tests that the page of costs puts the most expensive first, compared with the reference.
#include "grader/report/pages/costs_page.h"

#include <gtest/gtest.h>

#include <string>

#include "hair/io/plot/test_parsed.h"

namespace grader::inline report {
namespace {

Costs three_submissions() {
  Costs costs;
  costs.columns = {{"Compiler", "seconds", CostKind::wall_seconds},
                   {"Suite", "seconds", CostKind::wall_seconds},
                   {"Worker", "CPU seconds", CostKind::cpu_seconds},
                   {"Starts", "of the worker", CostKind::count}};
  costs.reference = {{"S1", {0, 0.5, 0.25, 2}}, {"H4", {0, 0.75, 0.5, 2}}};
  costs.submissions["alice"] = {{"S1", {1, 1, 900, 2}}, {"H4", {0, 1, 0.5, 2}}};
  costs.submissions["bob"] = {{"S1", {0, 2, 0.5, 2}}, {"H4", {3, 5, 4, 6}}};
  costs.submissions["carol"] = {};
  return costs;
}

// Tests that the words follow one another in a page.
void expect_in_order(const std::string& page, const std::vector<std::string>& words) {
  std::size_t at = 0;
  for (const std::string& word : words) {
    const std::size_t found = page.find(word, at);
    ASSERT_NE(found, std::string::npos) << "no \"" << word << "\" after \"" << page.substr(at, 80) << "\"";
    at = found + word.size();
  }
}

TEST(CostsPage, ShowsTheMostExpensiveFirst) {
  const std::string page = costs_page(three_submissions());
  expect_in_order(page, {"id=\"submissions\"", "staff/bob.html", ">10.00<", "H4, 80 %", "staff/alice.html",
                         ">3.00<", "S1, 67 %", "staff/carol.html", ">0.00<"});
  expect_in_order(page, {"id=\"parts\"", ">H4<", ">S1<", "id=\"submissions\""});
}

TEST(CostsPage, ShowsTheWholeClassBesideTheReference) {
  const std::string page = costs_page(three_submissions());
  expect_in_order(page, {"<strong>13</strong> seconds for 3 submissions", "All submissions", ">13.00<",
                         ">4.00<", ">9.00<", ">905.00<", ">12<", "on average", ">4.33<", ">4.0<",
                         "The reference", ">1.25<", ">0.75<", ">4<", "id=\"parts\""});
  // Two submissions were graded in H4.
  expect_in_order(
      page, {">H4<", ">4.50<", ">1.50<", ">3.00<", ">2.25<", ">4.0<", "69 %", "the reference", ">0.75<"});
}

// A person needs the cost, its share and its main part.
TEST(CostsPage, FoldsTheColumns) {
  const std::string page = costs_page(three_submissions());
  const std::string table = page.substr(page.find("id=\"submissions\""));
  const std::string head = table.substr(0, table.find("</thead>"));
  std::size_t cells = 0, folded = 0;
  for (std::size_t at = head.find("<th "); at != head.npos; at = head.find("<th ", at + 1)) {
    ++cells;
    folded += head.compare(at, 35, "<th scope=\"col\" class=\"number more\"") == 0;
  }
  EXPECT_EQ(cells - folded, 5U) << head;
  EXPECT_EQ(folded, 4U);
  expect_in_order(page,
                  {"<label class=\"fold\"><input type=\"checkbox\"/> Show all columns</label>", "<section"});
}

// In the other tables each row belongs to the row above it.
TEST(CostsPage, LetsReadersSortTheSubmissionsAlone) {
  const std::string page = costs_page(three_submissions());
  const std::size_t submissions = page.find("id=\"submissions\"");
  EXPECT_GT(page.find(" data-sort="), submissions);
  expect_in_order(page.substr(submissions), {"data-sort=\"text\"", "data-sort=\"number\""});
}

TEST(CostsPage, HasWhateverColumnsThereAre) {
  Costs costs = three_submissions();
  costs.columns.push_back({"Idle <s>", "waiting & sleeping", CostKind::cpu_seconds});
  for (auto& [name, parts] : costs.submissions)
    for (auto& [part, values] : parts) values.push_back(7.125);
  for (auto& [part, values] : costs.reference) values.push_back(0);
  const std::string page = costs_page(costs);
  EXPECT_NO_THROW(hair::plot::parse(page));
  expect_in_order(page, {"waiting &amp; sleeping", "Idle &lt;s&gt;", ">28.50<", "Idle &lt;s&gt;", ">7.12<"});
}

TEST(CostsPage, AStrictParserReadsItWithoutAnybody) {
  EXPECT_NO_THROW(hair::plot::parse(costs_page(three_submissions())));
  Costs none;
  EXPECT_NO_THROW(hair::plot::parse(costs_page(none)));
  none.columns = three_submissions().columns;
  EXPECT_NO_THROW(hair::plot::parse(costs_page(none)));
}

}  // namespace
}  // namespace grader::report
