// STAFF ONLY. Tests that recorded requests are repeated as they were, up to a bound.
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

TEST(Recording, HoldsRequestsWithTheirProductsAndOutcomes) {
  Recording recording;
  recording.begin_category("a category");
  recording.begin(numbers(16));
  recording.add_product(1, {}, {1, 2}, true);
  recording.add_product(0, {}, {}, false);
  recording.end(Outcome::stopped, kNoReply);
  ASSERT_EQ(recording.requests().size(), 1u);
  const Recording::Request& request = recording.requests()[0];
  EXPECT_EQ(request.category, "a category");
  EXPECT_EQ(request.message.bytes().size(), numbers(16).bytes().size());
  EXPECT_EQ(request.outcome, Outcome::stopped);
  ASSERT_EQ(request.products.size(), 2u);
  EXPECT_EQ(request.products[0].which, 1);
  EXPECT_EQ(request.products[0].result, (std::vector<double>{1, 2}));
  EXPECT_TRUE(request.products[0].go_on);
  EXPECT_FALSE(request.products[1].go_on);
}

TEST(Recording, HoldsSoMuchOfEachCategory) {
  Recording recording;
  for (const char* category : {"first", "second"}) {
    recording.begin_category(category);
    for (int i = 0; i < 8; ++i) {
      recording.begin(numbers(Recording::kMostBytes / 4 - 100));
      recording.end(Outcome::done, kNoReply);
    }
  }
  ASSERT_EQ(recording.requests().size(), 8u) << "four of each";
  EXPECT_EQ(recording.requests()[3].category, "first");
  EXPECT_EQ(recording.requests()[4].category, "second");
}

TEST(Recording, HoldsSoManyProductsOfEachRequest) {
  Recording recording;
  recording.begin_category("a category");
  const std::vector<double> product(Recording::kMostProductBytes / sizeof(double) / 2);
  for (int request = 0; request < 2; ++request) {
    recording.begin(numbers(8));
    for (int i = 0; i < 5; ++i) recording.add_product(0, {}, product, true);
    recording.end(Outcome::done, kNoReply);
  }
  ASSERT_EQ(recording.requests().size(), 2u);
  for (const Recording::Request& request : recording.requests()) EXPECT_EQ(request.products.size(), 2u);
}

}  // namespace
}  // namespace grader::judge
