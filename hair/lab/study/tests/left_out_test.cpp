// STAFF ONLY. A study before H6 is written: all other methods are there, and H6 is left out by name.
#include <gtest/gtest.h>

#include "hair/lab/study/study_record.h"
#include "studies.h"

namespace reference_tests {
namespace {

TEST(LeftOut, AMethodThatIsNotWrittenIsNamedAndTheOthersRun) {
  const hair::Study study = studied(kSoftHair, 0.05, {"h4-filtered", "h6"}, 1e5).whole();
  EXPECT_GE(sweep_of(study, "h4-filtered").runs.size(), 3u);
  const hair::Sweep& left_out = sweep_of(study, "h6");
  EXPECT_TRUE(left_out.runs.empty());
  EXPECT_EQ(left_out.end, hair::SweepEnd::not_written);
  EXPECT_TRUE(left_out.left_out.starts_with("H6 ")) << left_out.left_out;
  EXPECT_NE(hair::to_html(hair::study_page(study)).find("H6 is left out: H6 "), std::string::npos);
}

}  // namespace
}  // namespace reference_tests
