// STAFF ONLY. Tests that requests are recorded as they were, up to a bound.
#include "grader/judge/student/recording.h"

#include <gtest/gtest.h>

namespace grader::inline judge {
namespace {

const MessageReader kNoReply({});

MessageWriter numbers(std::size_t bytes) {
  MessageWriter message;
  message.put(std::span<const double>(std::vector<double>(bytes / sizeof(double))));
  return message;
}

TEST(Recording, HoldsRequestsWithTheirProducts) {
  Recording recording;
  recording.begin(numbers(16));
  recording.add_product(1, {}, {1, 2}, true);
  recording.add_product(0, {}, {}, false);
  recording.end(Outcome::stopped, kNoReply);
  ASSERT_EQ(recording.requests().size(), 1u);
  const Recording::Request& request = recording.requests()[0];
  EXPECT_EQ(request.message.bytes().size(), numbers(16).bytes().size());
  ASSERT_EQ(request.products.size(), 2u);
  EXPECT_EQ(request.products[0].which, 1);
  EXPECT_EQ(request.products[0].result, (std::vector<double>{1, 2}));
  EXPECT_TRUE(request.products[0].go_on);
  EXPECT_FALSE(request.products[1].go_on);
}

TEST(Recording, HoldsSoMuchAndSaysThatItIsCut) {
  Recording recording(Recording::Keeps::last_case);
  const std::vector<double> quarter(Recording::kMostBytes / 4 / sizeof(double));
  recording.begin_case();
  recording.begin(numbers(Recording::kMostBytes / 4 - 100));
  for (int i = 0; i < 2; ++i) recording.add_product(0, {}, quarter, true);
  EXPECT_FALSE(recording.is_cut());
  recording.add_product(0, quarter, quarter, true);
  recording.end(Outcome::done, kNoReply);
  recording.begin(numbers(Recording::kMostBytes / 2));
  EXPECT_TRUE(recording.is_cut());
  ASSERT_EQ(recording.requests().size(), 1u);
  EXPECT_EQ(recording.requests()[0].products.size(), 2u);
  recording.begin_case();
  EXPECT_FALSE(recording.is_cut());
}

}  // namespace
}  // namespace grader::judge
