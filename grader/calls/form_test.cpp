// STAFF ONLY. Tests with hand-made messages that forms refuse values that do not fit; and every call of every
// exercise with random arguments: they arrive unchanged, and any reply is taken or refused.
#include "grader/calls/form.h"

#include <gtest/gtest.h>

#include <limits>

#include "all_calls.h"
#include "grader/calls/client.h"
#include "grader/calls/draw_for_tests.h"
#include "grader/calls/in_words.h"
#include "grader/calls/relay.h"
#include "hair/course/course.h"
#include "reference/P1/calls.h"
#include "reference/P2/calls.h"
#include "reference/S1/calls.h"
#include "solver/test_refusal.h"

namespace grader::inline calls {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using particles::Constraints;

hair::Strand strand_of_three() {
  hair::Strand strand;
  strand.mass = Vector3d(1, 2, 3);
  strand.rest_length = Vector2d(0.1, 0.2);
  strand.stretch_rigidity = 4;
  strand.bend_rigidity = 5;
  strand.skip_rigidity = 6;
  strand.clamped = true;
  strand.root_tangent = Vector3d(0, 0.6, -0.8);
  return strand;
}

TEST(InWords, NamesTheFunctionAndTellsOfEachArgument) {
  const std::vector<Vector3d> many(5, Vector3d(1, -2, 0.5));
  EXPECT_EQ(
      in_words<particles::midpoint>(strand_of_three(), VectorXd(VectorXd::Constant(5, -2)), many,
                                    std::vector<int>{}, VectorXd(), Filling{}),
      "midpoint({(1, 2, 3), (0.1, 0.2), 4, 5, 6, 1, (0, 0.6, -0.8)}, 5 numbers up to 2, 5 of [(1, -2, 0.5)], "
      "[], (), ...)");
}

template <class T>
T sent(const T& value) {
  MessageWriter message;
  encode(message, value);
  MessageReader reader(message.bytes());
  T arrived;
  decode(reader, arrived);
  reader.expect_end();
  return arrived;
}

// Returns the refusal's words; empty if the message is read.
template <class T>
std::string refusal(const MessageWriter& message) {
  MessageReader reader(message.bytes());
  T value;
  return tests::refusal<MalformedMessage>([&] { decode(reader, value); });
}
template <class T>
std::string refusal_of(const T& value) {
  MessageWriter message;
  encode(message, value);
  return refusal<T>(message);
}

TEST(Form, OfAStrandHoldsAllOfIt) {
  const hair::Strand strand = strand_of_three(), arrived = sent(strand);
  EXPECT_EQ(arrived.mass, strand.mass);
  EXPECT_EQ(arrived.rest_length, strand.rest_length);
  EXPECT_EQ(arrived.stretch_rigidity, 4);
  EXPECT_EQ(arrived.bend_rigidity, 5);
  EXPECT_EQ(arrived.skip_rigidity, 6);
  EXPECT_TRUE(arrived.clamped);
  EXPECT_EQ(arrived.root_tangent, strand.root_tangent);
}

TEST(Form, OfAStrandRefusesOtherNumbersOfSegments) {
  EXPECT_EQ(refusal_of(hair::Strand()), "a strand without particles");
  for (int segments : {0, 1, 3}) {
    hair::Strand strand = strand_of_three();
    strand.rest_length = VectorXd::Ones(segments);
    EXPECT_EQ(refusal_of(strand), "a strand whose segments are not one fewer than its particles");
  }
}

TEST(Form, CutShortAnywhereIsRefused) {
  MessageWriter message;
  encode(message, strand_of_three());
  for (std::size_t size = 0; size < message.bytes().size(); ++size) {
    MessageReader reader(
        {message.bytes().begin(), message.bytes().begin() + static_cast<std::ptrdiff_t>(size)});
    hair::Strand strand;
    EXPECT_THROW(decode(reader, strand), MalformedMessage) << size << " bytes";
  }
}

// No length makes the reader take memory that the message does not fill.
TEST(Form, RefusesLengthsBeyondTheEnd) {
  for (std::uint64_t length : {std::uint64_t{2}, std::uint64_t{1} << 61, ~std::uint64_t{0}}) {
    MessageWriter message;
    message.put(length).put(1.0);
    EXPECT_NE(refusal<VectorXd>(message), "") << length << " numbers promised, 1 sent";
    EXPECT_NE(refusal<std::vector<double>>(message), "") << length << " items promised, 1 sent";
    EXPECT_NE(refusal<std::vector<particles::Rod>>(message), "") << length << " rods promised, none sent";
  }
}

TEST(Form, RefusesMatricesOfOtherSizes) {
  const MatrixXd matrix = MatrixXd::Random(2, 3);
  EXPECT_EQ(sent(matrix), matrix);
  const int most = std::numeric_limits<int>::max();
  for (const auto& [rows, columns] : {std::pair{2, 2}, {-2, -3}, {-1, 6}, {0, 6}, {most, most}}) {
    MessageWriter message;
    message.put(rows).put(columns).put(std::span<const double>(matrix.data(), 6));
    EXPECT_NE(refusal<MatrixXd>(message), "") << rows << " x " << columns;
  }
}

TEST(Form, OfParticlesWantsEachPinnedOrFree) {
  particles::Particles particles{Vector2d(1, 2), {1, 0}};
  EXPECT_EQ(sent(particles).pinned, particles.pinned);
  particles.pinned[0] = 'x';
  EXPECT_EQ(sent(particles).pinned[0], 1) << "whatever stands for true";
  particles.pinned.pop_back();
  EXPECT_EQ(refusal_of(particles), "particles of which some have no mass, or are neither pinned nor free");
}

TEST(Form, OfReportsBoundsSteps) {
  constexpr int kMost = std::numeric_limits<int>::max(), kLeast = std::numeric_limits<int>::min();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sent(particles::ConstraintReport{7, infinity}).steps, 7);
  EXPECT_EQ(sent(particles::ConstraintReport{7, infinity}).residual, infinity) << "numbers may be anything";
  EXPECT_EQ(sent(particles::ConstraintReport{kMost, 0}).steps, 1 << 28);
  EXPECT_EQ(sent(particles::ConstraintReport{kLeast, 0}).steps, -1);
  particles::SolveReport solve{};
  hair::CorrectionReport correction{};
  solve.steps = correction.iterations = kMost;
  EXPECT_EQ(sent(solve).steps, 1 << 28);
  EXPECT_EQ(sent(correction).iterations, 1 << 28);
}

// A list that was made longer or shorter goes back with its old length.
TEST(Fit, GivesBackLengths) {
  const Constraints before{{{0, 1, 2.0}, {1, 2, 3.0}}, {}, 1, 2};
  Constraints after = before;
  after.rods.resize(1);
  after.wires.resize(3);
  EXPECT_THROW(expect_like(after, before), MalformedMessage);
  fit(after, before);
  EXPECT_NO_THROW(expect_like(after, before));
  EXPECT_EQ(after.rods[0].length, 2.0);
}

// A reply of other lengths than the arguments is refused.
TEST(Client, TakesNoOtherLengths) {
  const VectorXd six = VectorXd::Ones(6), three = VectorXd::Ones(3);
  MessageWriter message;
  encode(message, particles::State{six, six});
  MessageReader states(message.bytes()), vectors(message.bytes());
  particles::State state{six, three};
  EXPECT_THROW((take_back<particles::State>(states, state)), MalformedMessage);
  EXPECT_EQ(state.v, three);
  VectorXd vector = three;
  EXPECT_THROW((take_back<VectorXd>(vectors, vector)), MalformedMessage);
  EXPECT_EQ(vector, three);
}

// A function of the reference writes to all columns that its contract names.
TEST(Server, GivesNoLessScratchThanTheContract) {
  const auto refused = [](int columns) {
    MessageWriter request, reply;
    request.put(0).put(1.0);  // forward_euler, h
    for (int vector = 0; vector < 2; ++vector) encode(request, VectorXd(VectorXd::Ones(3)));
    request.put(columns).put(0.0);
    MessageReader reader(request.bytes());
    draw::Source source(0);
    draw::Idle idle(source);
    return tests::refusal<MalformedMessage>([&] { serve<p1::Calls>(idle, reader, reply); });
  };
  EXPECT_EQ(refused(10), "");
  EXPECT_EQ(refused(13), "");
  EXPECT_EQ(refused(9), "scratch of 9 columns; expected 10");
  for (const int columns : {-1, 0, 1000, std::numeric_limits<int>::max()}) EXPECT_NE(refused(columns), "");
}

// Returns the error of a call's check; empty if the arguments fit.
template <class Check, class... Arguments>
std::string refusal_by(const Arguments&... arguments) {
  return tests::refusal<MalformedMessage>([&] { Check::check(arguments...); });
}

TEST(Check, OfASystemWantsAsManyNumbersAsUnknowns) {
  const VectorXd three = VectorXd::Ones(3), two = VectorXd::Ones(2);
  const auto refused = [](int rows, int cols, const VectorXd& x, const VectorXd& b) {
    return refusal_by<s1::SquareSystem>(Operator{rows, cols, nullptr}, x, b, 0.0, 0);
  };
  EXPECT_EQ(refused(3, 3, three, three), "");
  EXPECT_EQ(refused(3, 3, three, two), "a system of 3 unknowns with vectors of 3 and 2 numbers");
  EXPECT_NE(refused(3, 3, two, three), "");
  EXPECT_NE(refused(3, 2, three, three), "");
  EXPECT_NE(refused(1 << 30, 1 << 30, three, three), "");
}

TEST(Check, OfConstraintsWantsParticlesThatAreThere) {
  const VectorXd x = VectorXd::Ones(6);
  const auto rod = [&](int i, int j) {
    return refusal_by<p2::Values>(Constraints{{{i, j, 1.0}}, {}, 0, 0}, x, VectorXd(1));
  };
  EXPECT_EQ(rod(0, 1), "");
  EXPECT_EQ(rod(0, 2), "a constraint of particle 2 of 2");
  EXPECT_EQ(rod(-1, 1), "a constraint of particle -1 of 2");
  EXPECT_NE(rod(std::numeric_limits<int>::max(), 0), "");
  const Constraints bead{{}, {{2, Vector3d::Zero(), Vector3d::UnitX(), 1}}, 0, 0};
  EXPECT_NE(refusal_by<p2::Values>(bead, x, VectorXd(2)), "");
}

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
