#include "hair/lab/validate/record.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace hair {
namespace {

using Json = OrderedJson;

Check a_check(double measured) {
  return {"one", "a length", "a book", 2, measured, 0.5, "a theorem", "m"};
}

ValidationRecord a_record(double measured) {
  return {"first", "The first", {"S1"}, {{a_check(measured)}}};
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Check, HoldsWithinItsTolerance) {
  EXPECT_TRUE(a_check(2.5).holds());
  EXPECT_TRUE(a_check(1.5).holds());
  EXPECT_FALSE(a_check(2.5000001).holds());
  EXPECT_FALSE(a_check(1.4999999).holds());
}

TEST(Check, NothingHoldsForWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  for (const double none : {nan, infinity, -infinity}) {
    EXPECT_FALSE(a_check(none).holds());
    Check check = a_check(2);
    check.tolerance = nan;
    EXPECT_FALSE(check.holds());
    check = a_check(none);
    check.tolerance = infinity;
    EXPECT_FALSE(check.holds());
  }
}

TEST(ValidationRecord, HoldsIfItRanToItsEndAndAllChecksHold) {
  EXPECT_TRUE(a_record(2).holds());
  EXPECT_FALSE(a_record(3).holds());
  ValidationRecord record = a_record(2);
  record.broke = "it threw";
  EXPECT_FALSE(record.holds());
  record = a_record(2);
  record.left_out = "S1: student/conj_grad.cpp";
  EXPECT_FALSE(record.holds());
}

TEST(ValidationRecord, SaysOnTheTerminalWhatDoesNotHold) {
  EXPECT_TRUE(has(terminal_text(a_record(2)), " ok\n"));
  EXPECT_FALSE(has(terminal_text(a_record(2)), "DOES NOT HOLD"));
  EXPECT_TRUE(has(terminal_text(a_record(3)), "a length, m"));
  EXPECT_TRUE(has(terminal_text(a_record(3)), "DOES NOT HOLD"));
  EXPECT_EQ(summary({a_record(2), a_record(3)}), "1 of 2 checks hold");
}

TEST(ValidationRecord, IsOnThePageWithSourcesAndTolerances) {
  const std::string page = to_html(page_of({a_record(3)}));
  for (const char* part : {"The first", "a length, m", "a book", "a theorem", "NO", "0 of 1 checks hold"})
    EXPECT_TRUE(has(page, part)) << part;
}

TEST(ValidationRecord, AFigureThatCannotBeDrawnDoesNotCostThePage) {
  ValidationRecord record = a_record(3);
  Figure figure;
  figure.id = "broken";
  figure.series = {{"nothing", {{1, std::numeric_limits<double>::quiet_NaN()}}}};
  record.result.figures = {figure};
  const std::string page = to_html(page_of({record}));
  EXPECT_TRUE(has(page, "a theorem"));
  EXPECT_TRUE(has(page, "A figure can")) << page;
}

std::vector<ValidationRecord> of_each_kind() {
  ValidationRecord left_out{"second", "The second", {"H2"}, {}}, broke{"third", "The third", {"H1"}, {}};
  left_out.left_out = "H2: student/angular_springs.cpp";
  broke.broke = "it threw";
  return {a_record(2), left_out, broke};
}

TEST(ValidationRecord, WhatBrokeOrIsLeftOutIsInAllThatIsWritten) {
  EXPECT_EQ(summary(of_each_kind()),
            "1 of 1 checks hold; 1 of 3 validations broke; 1 of 3 validations are left out");
  const std::string csv = csv_of(check_rows(of_each_kind()));
  EXPECT_TRUE(has(csv, "second,,,,left out: it needs H2: student/angular_springs.cpp,,,,,\n")) << csv;
  EXPECT_TRUE(has(csv, "third,,,,broke: it threw,,,,,NO\n")) << csv;
  const Json json = json_of(of_each_kind())["validations"];
  EXPECT_EQ(json[0]["holds"], true);
  EXPECT_EQ(json[0]["checks"][0]["tolerance_from"], "a theorem");
  EXPECT_TRUE(json[1]["holds"].is_null());
  EXPECT_EQ(json[1]["left_out"], "H2: student/angular_springs.cpp");
  EXPECT_EQ(json[2]["holds"], false);
  EXPECT_EQ(json[2]["broke"], "it threw");
}

}  // namespace
}  // namespace hair
