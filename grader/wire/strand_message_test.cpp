// STAFF ONLY.
#include "grader/wire/strand_message.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace grader {
namespace {

hair::Strand strand_of_three() {
  hair::Strand strand;
  strand.mass = Eigen::Vector3d(1, 2, 3);
  strand.rest_length = Eigen::Vector2d(0.1, 0.2);
  strand.stretch_rigidity = 4;
  strand.bend_rigidity = 5;
  strand.skip_rigidity = 6;
  strand.clamped = true;
  strand.root_tangent = Eigen::Vector3d(0, 0.6, -0.8);
  return strand;
}

hair::Strand sent(const hair::Strand& strand) {
  MessageWriter message;
  put(message, strand);
  MessageReader reader(message.bytes());
  const hair::Strand result = get_strand(reader);
  reader.expect_end();
  return result;
}

TEST(StrandMessage, ArrivesAsItWasSent) {
  const hair::Strand strand = strand_of_three(), arrived = sent(strand);
  EXPECT_EQ(arrived.mass, strand.mass);
  EXPECT_EQ(arrived.rest_length, strand.rest_length);
  EXPECT_EQ(arrived.stretch_rigidity, 4);
  EXPECT_EQ(arrived.bend_rigidity, 5);
  EXPECT_EQ(arrived.skip_rigidity, 6);
  EXPECT_TRUE(arrived.clamped);
  EXPECT_EQ(arrived.root_tangent, strand.root_tangent);
}

TEST(StrandMessage, HoldsAStrandOfOneParticle) {
  hair::Strand strand;
  strand.mass = Eigen::VectorXd::Constant(1, 7);
  const hair::Strand arrived = sent(strand);
  EXPECT_EQ(arrived.count(), 1);
  EXPECT_EQ(arrived.segments(), 0);
  EXPECT_FALSE(arrived.clamped);
}

TEST(StrandMessage, WithoutParticlesIsMalformed) {
  MessageWriter message;
  put(message, hair::Strand());
  MessageReader reader(message.bytes());
  EXPECT_THROW(get_strand(reader), MalformedMessage);
}

TEST(StrandMessage, WithAnotherNumberOfSegmentsIsMalformed) {
  for (int segments : {0, 1, 3}) {
    hair::Strand strand = strand_of_three();
    strand.rest_length = Eigen::VectorXd::Ones(segments);
    MessageWriter message;
    put(message, strand);
    MessageReader reader(message.bytes());
    EXPECT_THROW(get_strand(reader), MalformedMessage) << segments << " segments of 3 particles";
  }
}

TEST(StrandMessage, WithALengthBeyondItsEndIsMalformed) {
  for (std::uint64_t length : {std::uint64_t{2}, std::uint64_t{1} << 61, ~std::uint64_t{0}}) {
    MessageWriter message;
    message.put(length).put(1.0);
    MessageReader reader(message.bytes());
    EXPECT_THROW(get_strand(reader), MalformedMessage) << length << " numbers promised, 1 sent";
  }
}

TEST(StrandMessage, CutShortAnywhereIsMalformed) {
  MessageWriter message;
  put(message, strand_of_three());
  for (std::size_t size = 0; size < message.bytes().size(); ++size) {
    MessageReader reader(
        {message.bytes().begin(), message.bytes().begin() + static_cast<std::ptrdiff_t>(size)});
    EXPECT_THROW(get_strand(reader), MalformedMessage)
        << size << " of " << message.bytes().size() << " bytes";
  }
}

}  // namespace
}  // namespace grader
