// STAFF ONLY. Tests that messages are read as they were written.
#include "grader/wire/message.h"

#include <gtest/gtest.h>

#include <unistd.h>
#include <limits>
#include <string>

#include "grader/wire/channel.h"

namespace grader::inline wire {
namespace {

TEST(Message, IsReadAsItWasWritten) {
  const std::vector<double> values = {1, -0.0, std::numeric_limits<double>::infinity()};
  MessageWriter writer;
  writer.put(7).put(std::span<const double>(values)).put(std::string("text")).put(2.5);
  MessageReader reader(writer.bytes());
  EXPECT_EQ(reader.get<int>(), 7);
  EXPECT_EQ(reader.get_doubles(3), values);
  EXPECT_EQ(reader.get_text(), "text");
  EXPECT_EQ(reader.get<double>(), 2.5);
  EXPECT_NO_THROW(reader.expect_end());
}

TEST(Message, ATextOfAWorkerHasNoControlCharacters) {
  MessageWriter writer;
  writer.put(std::string("a\nb\x1b[2Jc\x7f"));
  EXPECT_EQ(MessageReader(writer.bytes()).get_text(), "a b [2Jc ");
  EXPECT_EQ(MessageReader(writer.bytes()).get_document(), "a\nb\x1b[2Jc\x7f");
}

TEST(Message, ThatIsTooShortIsMalformedAtEveryLength) {
  MessageWriter writer;
  writer.put(7).put(std::vector<double>{1, 2, 3}).put(std::string("text"));
  for (std::size_t size = 0; size < writer.bytes().size(); ++size) {
    MessageReader reader(
        {writer.bytes().begin(), writer.bytes().begin() + static_cast<std::ptrdiff_t>(size)});
    EXPECT_THROW(
        {
          reader.get<int>();
          reader.get_doubles();
          reader.get_text();
        },
        MalformedMessage)
        << "of " << size << " bytes";
  }
}

TEST(Message, WithBytesLeftOverIsMalformed) {
  MessageWriter writer;
  writer.put(1.0);
  EXPECT_THROW(MessageReader(writer.bytes()).expect_end(), MalformedMessage);
}

TEST(Channel, CarriesMessagesAndSaysWhenTheOtherSideIsGone) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  Channel channel(ends[0], ends[1]);
  MessageWriter writer;
  writer.put(42);
  ASSERT_TRUE(channel.send(Kind::done, 99, writer.bytes()));
  const std::optional<Message> message = channel.receive(100);
  ASSERT_TRUE(message);
  EXPECT_EQ(message->kind, Kind::done);
  EXPECT_EQ(message->nonce, 99U);
  EXPECT_EQ(MessageReader(message->body).get<int>(), 42);

  ASSERT_TRUE(channel.send(Kind::done, 99, writer.bytes()));
  EXPECT_THROW(channel.receive(3), MalformedMessage);
  close(ends[1]);
  MessageWriter rest;
  EXPECT_FALSE(channel.receive(100).has_value());
  close(ends[0]);
}

}  // namespace
}  // namespace grader::wire
