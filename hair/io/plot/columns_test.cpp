// JSON, CSV and tables of pages follow from declared columns.
#include "hair/io/plot/columns.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hair {
namespace {

std::string inverse(double value) {
  return "1/" + to_text(1 / value);
}

Row row_of(int elements, double step, std::optional<double> error, const std::string& trouble,
           std::vector<double> lengths) {
  return {{"elements", "", elements},
          {"step", "s", step, {"h", 1, inverse}},
          {"error.at_end", "m", error, {.heading = "error, mm", .scale = 1e3}},
          {"error.name", "", "rms", In::json},
          {"trouble", "", if_any(trouble)},
          {"stopped", "", !trouble.empty(), In::files},
          {"lengths", "", lengths, In::json},
          {"size_of.it", "kg", 0.5, In::page},
          {"remark", "", "all, of it", In::csv}};
}

const std::vector<Row> kRows = {row_of(5, 0.25, 1.0 / 3, "", {}), row_of(10, 0.125, {}, "broke", {1, NAN})};

TEST(Columns, AreKeysInJsonAndDotsObjects) {
  EXPECT_EQ(
      json_of(kRows).dump(),
      R"([{"elements":5,"step":0.25,"error":{"at_end":0.3333333333333333,"name":"rms"},"trouble":null,)"
      R"("stopped":false,"lengths":[]},{"elements":10,"step":0.125,"error":{"at_end":null,"name":"rms"},)"
      R"("trouble":"broke","stopped":true,"lengths":[1.0,null]}])");
}

TEST(Columns, OfCsvHaveNameAndUnitAndAllDigits) {
  EXPECT_EQ(
      csv_of(kRows),
      "elements,step_s,error_at_end_m,trouble,stopped,remark\n5,0.25,0.3333333333333333,,no,\"all, of it\"\n"
      "10,0.125,,broke,yes,\"all, of it\"\n");
  EXPECT_EQ(csv_of({}), "");
}

TEST(Columns, OfPagesHaveHeadingsScalesAndWaysToWriteNumbers) {
  const Table table = table_of(kRows, "Runs");
  EXPECT_EQ(table.caption, "Runs");
  EXPECT_EQ(table.header,
            (std::vector<std::string>{"elements", "h", "error, mm", "trouble", "size of it, kg"}));
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"5", "1/4", "333", "", "0.5"}));
  EXPECT_EQ(table.rows[1], (std::vector<std::string>{"10", "1/8", "", "broke", "0.5"}));
}

TEST(Columns, OfHostileTextsAreARecordAllTheSame) {
  EXPECT_EQ(record_text({{"a", "\xff"}}), "{\n  \"a\": \"\xef\xbf\xbd\"\n}\n");
}

}  // namespace
}  // namespace hair
