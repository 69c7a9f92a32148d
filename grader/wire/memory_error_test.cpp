// STAFF ONLY. What a worker says of a memory error is a row of our table and numbers.
#include "grader/wire/memory_error.h"

#include <gtest/gtest.h>

#include <string>

namespace grader {
namespace {

MemoryError read(std::uint32_t kind, std::uint32_t frames, std::uint32_t sent) {
  MessageWriter message;
  message.put(kind).put(frames);
  for (std::uint32_t i = 0; i < sent; ++i) message.put(std::uint64_t{i});
  MessageReader reader(message.bytes());
  return read_memory_error(reader);
}

TEST(MemoryError, IsARowOfTheTable) {
  const auto row = memory_error_kind("heap-use-after-free");
  ASSERT_TRUE(row);
  const MemoryError error = read(*row, 2, 2);
  EXPECT_STREQ(error.shown(), "uses memory that is freed already");
  EXPECT_EQ(error.offsets, (std::vector<std::uint64_t>{0, 1}));
}

TEST(MemoryError, OfAKindThatIsNotThereBreaksTheRules) {
  EXPECT_THROW(read(static_cast<std::uint32_t>(memory_error_kinds().size()), 0, 0), MalformedMessage);
  EXPECT_THROW(read(~0U, 0, 0), MalformedMessage);
}

TEST(MemoryError, WithAWrongNumberOfFramesBreaksTheRules) {
  EXPECT_THROW(read(0, kMostFrames + 1, kMostFrames + 1), MalformedMessage);
  EXPECT_THROW(read(0, 2, 1), MalformedMessage);
  EXPECT_THROW(read(0, 1, 2), MalformedMessage);
}

// Memory and stack that are used up are limits of ours.
TEST(MemoryError, DoesNotIncludeLimits) {
  for (const char* limit :
       {"stack-overflow", "out-of-memory", "allocation-size-too-big", "rss-limit-exceeded", ""})
    EXPECT_FALSE(memory_error_kind(limit)) << limit;
}

TEST(MemoryError, IsShownInWordsOfOurs) {
  for (const MemoryErrorKind& kind : memory_error_kinds()) {
    EXPECT_EQ(memory_error_kind(kind.runtime),
              static_cast<std::uint32_t>(&kind - memory_error_kinds().data()))
        << kind.runtime << " stands there twice";
    EXPECT_FALSE(std::string(kind.shown).empty());
  }
}

}  // namespace
}  // namespace grader
