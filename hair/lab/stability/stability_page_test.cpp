// STAFF ONLY. A stability page reports every disagreement, and claims nothing without a measurement.

#include <gtest/gtest.h>

#include <limits>

#include "hair/lab/stability/report.h"

namespace reference_tests {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const std::vector<double> kSteps = {1, 2, 4, 8, 16, 32, 64, 128};

// The steps of the boundary and of theory's limit in each column. Where one has left the map they disagree,
// unless both left it on one side.
TEST(StabilityDistance, IsInCellsAndCountsColumnsWhereOneHasLeftTheMap) {
  const struct {
    std::vector<double> boundary, limit;
    int columns, beyond;
    double beyond_cells;
  } cases[] = {{{4, 8, 16}, {4, 4, 32}, 3, 0, 0},
               {{kInfinity, kInfinity}, {4, 8}, 0, 2, 5},  // from 4 to 128
               {{0, 0, 8}, {16, 4, 8}, 1, 2, -4},          // from 16 to 1
               {{8, kInfinity}, {kInfinity, 0}, 0, 2, 7},
               {{kInfinity, 0, kInfinity}, {kInfinity, 0, 500}, 0, 0, 0}};
  for (const auto& one : cases) {
    SCOPED_TRACE(&one - cases);
    const hair::Distance distance = hair::distance_of(one.boundary, one.limit, kSteps);
    EXPECT_EQ(distance.columns, one.columns);
    EXPECT_EQ(distance.columns_beyond, one.beyond);
    EXPECT_DOUBLE_EQ(distance.beyond_cells, one.beyond_cells);
  }
  const hair::Distance signs = hair::distance_of({4, 8, 16}, {4, 4, 32}, kSteps);
  EXPECT_DOUBLE_EQ(signs.median_cells, 0);
  EXPECT_DOUBLE_EQ(std::abs(signs.worst_cells), 1);
}

// The first row is wrong already: there is no lower cell for a boundary between two.
TEST(StabilityDistance, ABoundaryBelowTheMapIsZero) {
  hair::RefinedGrid grid;
  grid.cells = {2, 0, 0,   //
                2, 3, 0};  // from the lowest row up
  const std::vector<double> boundary = hair::boundary_of(grid, {1, 4});
  EXPECT_EQ(boundary, (std::vector<double>{0, 2, kInfinity}));
}

// A map of two columns whose cells are all of one class, compared with a limit.
std::string said_of(hair::Fate fate, double limit) {
  hair::StabilityMap map;
  map.method.id = map.method.name = "method";
  map.xs = {1, 10};
  map.hs = kSteps;
  map.grid = {std::vector<int>(2 * kSteps.size(), static_cast<int>(fate)), 16, true};
  map.steps = 100;
  map.boundary = hair::boundary_of(map.grid, map.hs);
  map.limits = {{"theory", {limit, limit}}};
  map.limits[0].distance = hair::distance_of(map.boundary, map.limits[0].h, map.hs);
  hair::StabilityReport report;
  report.scene = "a scene";
  report.maps = {map};
  return hair::to_html(hair::page_of(report)) + hair::csv_of(hair::limit_rows(report)) +
         hair::csv_of(hair::curve_rows(report)) + hair::record_text(hair::json_of(report));
}

void expect_said(const std::string& text, const std::string& part, bool is) {
  EXPECT_EQ(text.find(part) != std::string::npos, is) << part;
}

TEST(StabilityPage, SaysAgreementOnlyWhereTheMapAgrees) {
  const struct {
    double limit;
    const char *agrees, *differs;
    hair::Fate with;
  } cases[] = {
      {0, "no step is stable, and no cell is", "no step is stable, but so few steps", hair::Fate::blown_up},
      {kInfinity, "none, and none was found", "none, but a boundary was found", hair::Fate::stable}};
  for (const auto& one : cases)
    for (const hair::Fate fate : {hair::Fate::stable, hair::Fate::blown_up}) {
      const std::string text = said_of(fate, one.limit);
      expect_said(text, one.agrees, fate == one.with);
      expect_said(text, one.differs, fate != one.with);
    }
}

TEST(StabilityPage, SaysHowFarTheyAreApartWhereOneIsNotOnTheMap) {
  for (const hair::Fate fate : {hair::Fate::stable, hair::Fate::blown_up}) {
    const std::string text = said_of(fate, 8);
    expect_said(text, "in 2 columns where one of them is not on the map they are apart, by ", true);
    expect_said(text, fate == hair::Fate::stable ? "+4.00 cells at least" : "-3.00 cells at least", true);
    expect_said(text, "cells from it (median)", false);
    expect_said(text, "\"columns_beyond\": 2", true);
  }
}

}  // namespace
}  // namespace reference_tests
