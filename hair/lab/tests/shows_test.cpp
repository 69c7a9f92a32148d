// The pages of the first exercises, whatever the code does that they show.
#include <gtest/gtest.h>

#include <cmath>

#include "hair/lab/bowl/bowl_page.h"
#include "hair/lab/phase/phase_plane.h"

namespace hair {
namespace {

using solver::study::BowlPath;

TEST(BowlPage, SaysAPathByItsPlaces) {
  BowlPath path = {"ConjGrad", 1, 0, 1, 1, {0, 0}, {3, 4}, {{3, 4}, {1, 0}, {0, 0}, {0, 0}}};
  EXPECT_EQ(bowl::path_verdict(path),
            "It begins at b, as it should. It is at the bottom after 2 steps; two unknowns take 2.");
  path.places = {{0, 5}, {1, 0}};
  EXPECT_EQ(
      bowl::path_verdict(path),
      "It does not begin at b, as it should. After 1 step its height is still 0.04 of the first guess's; two "
      "unknowns take 2 steps.");
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
