// STAFF ONLY.
#include "grader/wire/synthesis_message.h"

#include <gtest/gtest.h>

namespace grader {
namespace {

TEST(SynthesisMessage, GivesBackWhatWasPut) {
  const OwnGuide guide{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}, Eigen::VectorXd::LinSpaced(9, 10, 18)};
  hair::GuideFrames frames{Eigen::Vector3d(0, 0.25, 1), std::vector<hair::Matrix3d>(3)};
  for (int i = 0; i < 3; ++i) frames.turns[i] << i, 1, 2, 3, 4, 5, 6, 7, 8;
  MessageWriter message;
  put(message, guide);
  put(message, frames);

  MessageReader reader(message.bytes());
  const OwnGuide got = get_guide(reader);
  EXPECT_EQ(got.root.position, guide.root.position);
  EXPECT_EQ(got.root.axis, guide.root.axis);
  EXPECT_EQ(got.root.side, guide.root.side);
  EXPECT_EQ(got.points, guide.points);
  const hair::GuideFrames carried = get_guide_frames(reader, 3);
  EXPECT_EQ(carried.arc, frames.arc);
  EXPECT_EQ(carried.turns, frames.turns);
  reader.expect_end();
}

TEST(SynthesisMessage, RefusesGuidesThatAreNone) {
  for (const int numbers : {0, 3, 7}) {
    MessageWriter message;
    put(message, OwnGuide{{}, Eigen::VectorXd::Zero(numbers)});
    MessageReader reader(message.bytes());
    EXPECT_THROW(get_guide(reader), MalformedMessage) << numbers << " numbers";
  }
  MessageWriter message;
  put(message, hair::GuideFrames{Eigen::VectorXd::Zero(3), std::vector<hair::Matrix3d>(3)});
  MessageReader reader(message.bytes());
  EXPECT_THROW(get_guide_frames(reader, 4), MalformedMessage);
}

}  // namespace
}  // namespace grader
