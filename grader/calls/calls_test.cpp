// STAFF ONLY. Tests every call of every exercise with random arguments: they arrive unchanged, and any reply
// is taken or refused.
#include <gtest/gtest.h>

#include "all_calls.h"
#include "grader/calls/draw_for_tests.h"
#include "grader/calls/in_words.h"
#include "grader/calls/relay.h"
#include "hair/course/course.h"

namespace grader::inline calls {
namespace {

using Bytes = std::vector<std::byte>;
using hair::Course, hair::plain_name, hair::read_course;

constexpr int kTries = 2000, kMostTries = 400'000, kEnough = 5;

void expect(bool kept, const char* promise) {
  EXPECT_TRUE(kept) << promise;
}

void expect_readable(const char* message) {
  const std::string_view text(message);
  EXPECT_FALSE(text.empty());
  EXPECT_EQ(text.find_first_of("\n\r\t\x1b"), std::string_view::npos) << text;
}

// Makes a reply of the right form.
template <class Calls>
Bytes reply_to(const MessageWriter& request, draw::Source& source) {
  draw::Idle idle(source);
  MessageReader reader(request.bytes());
  MessageWriter reply;
  serve<Calls>(idle, reader, reply);
  return reply.bytes();
}

// Cuts, extends or changes bytes.
Bytes poisoned(Bytes bytes, draw::Source& source) {
  const int size = static_cast<int>(bytes.size()), at = source.integer(0, std::max(0, size - 1));
  switch (source.integer(0, 3)) {
    case 0:
      bytes.resize(static_cast<std::size_t>(at));
      break;
    case 1:
      bytes.resize(bytes.size() + static_cast<std::size_t>(source.integer(1, 9)));
      break;
    case 2:
      for (int i = at; i < std::min(at + 8, size); ++i) bytes[static_cast<std::size_t>(i)] = std::byte{0xff};
      break;
    default:
      for (int i = at; i < std::min(at + 8, size); ++i)
        bytes[static_cast<std::size_t>(i)] = static_cast<std::byte>(source.integer(0, 255));
  }
  return bytes;
}

TEST(Calls, ArriveAsTheyWereSent) {
  for_each_exercise([]<class Calls>() {
    for_each_call<Calls>([]<int number>() {
      draw::Source source(number);
      int arrived = 0;
      relay::Way way;
      way.expect = expect;
      way.end = [&](const MessageWriter& request, const Products&) {
        arrived += source.particles() > 0;
        return MessageReader(reply_to<Calls>(request, source));
      };
      for (int i = 0; i < kMostTries && arrived < kEnough; ++i)
        relay::send<Calls>(way, draw::request<Calls, number>(source), expect_readable);
      EXPECT_GT(arrived, 0) << Calls::id << ", call " << number << ": of all that was drawn, nothing fits";
    });
  });
}

TEST(Calls, TakeOrRefuseAnyRequestAndReply) {
  for_each_exercise([]<class Calls>() {
    for_each_call<Calls>([]<int number>() {
      draw::Source source(1000 + number);
      relay::Way way;
      way.expect = expect;
      way.end = [&](const MessageWriter& request, const Products& products) {
        std::vector<double> question(static_cast<std::size_t>(source.length() * source.integer(1, 4))),
            answer;
        try {
          products(source.integer(0, 1) == 0 ? source.integer(-1, 2) : source.integer(99, 105), question,
                   answer);
        } catch (const MalformedMessage& error) {
          expect_readable(error.what());
        } catch (const std::invalid_argument& error) {  // an object of ours, asked for another size
          expect_readable(error.what());
        }
        return MessageReader(poisoned(reply_to<Calls>(request, source), source));
      };
      for (int i = 0; i < kTries; ++i) {
        const Bytes request = draw::request<Calls, number>(source);
        relay::send<Calls>(way, i % 2 == 0 ? request : poisoned(request, source), expect_readable);
      }
    });
  });
}

// A function with other arguments stands before some, and its name is a part of theirs: a report must still
// name the right one.
TEST(Calls, StandInTheOrderOfTheExercisesFunctions) {
  const Course course = read_course(std::filesystem::path(HAIR_PROJECT) / "handout/exercises.json");
  for_each_exercise([&]<class Calls>() {
    for_each_call<Calls>([&]<int number>() {
      const std::vector<std::string>& functions = course.find(Calls::id)->functions;
      if (functions.size() > 1 && number < functions.size()) {
        EXPECT_TRUE(
            plain_name(functions[number]).starts_with(name_of<Calls::template At<number>::function>()))
            << Calls::id << ", call " << number << ": " << functions[number];
      }
    });
  });
}

TEST(Calls, OfAnotherListAreRefused) {
  for_each_exercise([]<class Calls>() {
    for (const int number : {-1, Calls::count, std::numeric_limits<int>::max()}) {
      draw::Source source(0);
      draw::Idle idle(source);
      MessageWriter request, reply;
      request.put(number);
      MessageReader reader(request.bytes());
      EXPECT_THROW(serve<Calls>(idle, reader, reply), MalformedMessage) << Calls::id << ", call " << number;
    }
  });
}

}  // namespace
}  // namespace grader::calls
