// STAFF ONLY. Tests that a worker can only choose a row of our table of memory errors.
#include "grader/wire/memory_error.h"

#include <gtest/gtest.h>

#include <string>

namespace grader::inline wire {
namespace {

const MemoryErrorKind& read(const MessageWriter& message) {
  MessageReader reader(message.bytes());
  return read_memory_error(reader);
}

TEST(MemoryError, IsARowOfTheTableAndNothingElse) {
  const auto row = memory_error_kind("heap-use-after-free");
  ASSERT_TRUE(row);
  EXPECT_STREQ(read(MessageWriter().put(*row)).shown, "uses memory that is freed already");
  const auto rows = static_cast<std::uint32_t>(memory_error_kinds().size());
  EXPECT_THROW(read(MessageWriter().put(rows)), MalformedMessage);
  EXPECT_THROW(read(MessageWriter().put(~0U)), MalformedMessage);
  EXPECT_THROW(read(MessageWriter().put(*row).put(1)), MalformedMessage) << "a place";
}

// Used-up memory and stack are limits of ours.
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
}  // namespace grader::wire
