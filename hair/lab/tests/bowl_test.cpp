// The sentences on the paths over the bowl follow from their places; and hairlab writes them, with and
// without the solved exercises.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "hair/lab/bowl/bowl_page.h"
#include "hair/lab/tests/run_hairlab.h"

namespace hair {
namespace {

using solver::study::BowlPath;

TEST(BowlCommand, ShowsBothWaysToTheBottom) {
  const TestFolder folder;
  const std::filesystem::path out = folder / "out";
  const ProgramRun done = run_hairlab({"bowl", "--out", out.string()});
  ASSERT_EQ(done.code, 0) << done.errors;
  EXPECT_EQ(folder.names("out"), (std::vector<std::string>{"bowl.csv", "bowl.json", "index.html"}));
  const auto record = nlohmann::json::parse(bytes_of(out / "bowl.json"));
  EXPECT_TRUE(record["left_out"].is_null());
  EXPECT_EQ(record["paths"].size(), 18) << "two of nine places";
  const std::string page = bytes_of(out / "index.html");
  for (const char* figure : {"path", "normal-path"})
    EXPECT_TRUE(has(page, "id=\"" + std::string(figure) + "\"")) << figure;
  EXPECT_TRUE(has(page, "It begins at b, as it should. It is at the bottom after 2 steps"));
  EXPECT_TRUE(has(page, "It begins at A&#39;b, as it should. It is at the bottom after 2 steps"));
}

TEST(BowlCommand, NamesTheExerciseThatIsNotWritten) {
  const TestFolder folder;
  const ProgramRun done =
      run_hairlab({"bowl", "--out", (folder / "out").string()}, {.program = STUDENT_HAIRLAB});
  EXPECT_EQ(done.code, 3) << done.errors;
  EXPECT_TRUE(has(done.errors, "S1: student/conj_grad.cpp, ConjGrad is not implemented yet")) << done.errors;
  EXPECT_TRUE(folder.names().empty());
}

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

}  // namespace
}  // namespace hair
