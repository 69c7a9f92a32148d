// STAFF ONLY. Reads hostile bytes as every call of every exercise: as the request that a server reads, and as
// the questions and the reply that a client gets. They go the way of relay.h. The first byte of the input is
// the exercise's place in the list; then come the request's length, in two bytes, and the request; then the
// number of questions, and each in two bytes: the operator, and how many numbers it gets; the rest is the
// reply.
#include <algorithm>

#include "all_calls.h"
#include "grader/calls/draw_for_tests.h"
#include "grader/calls/relay.h"
#include "hair/io/fuzz/fuzz.h"

namespace {

using Bytes = std::vector<std::byte>;

class Input {
 public:
  explicit Input(std::string_view bytes) : bytes_(bytes) {}

  unsigned byte() {
    if (bytes_.empty()) return 0;
    const auto value = static_cast<unsigned char>(bytes_[0]);
    bytes_.remove_prefix(1);
    return value;
  }
  Bytes take(std::size_t count) {
    count = std::min(count, bytes_.size());
    const auto* begin = reinterpret_cast<const std::byte*>(bytes_.data());
    bytes_.remove_prefix(count);
    return {begin, begin + count};
  }
  Bytes rest() { return take(bytes_.size()); }

 private:
  std::string_view bytes_;
};

// Returns the number of a matrix, or of a force's question: force_message.h.
int operator_of(unsigned byte) {
  return byte < 128 ? static_cast<int>(byte) - 1 : static_cast<int>(byte) - 128 + grader::kForceEnergy - 1;
}

template <class Calls>
void try_calls(Input input) {
  const unsigned high = input.byte(), low = input.byte();
  const Bytes request = input.take(256 * high + low);
  grader::relay::Way way;
  way.expect = fuzz::expect;
  way.end = [&](const grader::MessageWriter&, const grader::Products& products) {
    for (unsigned questions = input.byte() % 4; questions > 0; --questions) {
      const int which = operator_of(input.byte());
      std::vector<double> question(input.byte(), 1.0), answer;
      try {
        products(which, question, answer);
      } catch (const std::invalid_argument& error) {  // an object of ours, asked for another size
        fuzz::expect_readable(error.what());
      }
    }
    return grader::MessageReader(input.rest());
  };
  grader::relay::send<Calls>(way, request, fuzz::expect_readable);
}

// Makes a request that fits, with a reply that does.
template <class Calls, int number>
std::string seed(int exercise) {
  grader::draw::Source source(number);
  Bytes request, reply;
  grader::relay::Way way;
  way.expect = fuzz::expect;
  way.end = [&](const grader::MessageWriter& sent, const grader::Products&) {
    grader::draw::Idle idle(source);
    grader::MessageReader reader(sent.bytes());
    grader::MessageWriter writer;
    grader::serve<Calls>(idle, reader, writer);
    reply = writer.bytes();
    return grader::MessageReader(reply);
  };
  do {
    request = grader::draw::request<Calls, number>(source);
    grader::relay::send<Calls>(way, request, fuzz::expect_readable);
  } while (reply.empty());

  const auto text = [](const Bytes& bytes) {
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  const std::string before = {static_cast<char>(exercise), static_cast<char>(request.size() / 256),
                              static_cast<char>(request.size() % 256)};
  const std::string no_questions(1, '\0');
  return before + text(request) + no_questions + text(reply);
}

}  // namespace

void fuzz::try_input(std::string_view bytes) {
  Input input(bytes);
  unsigned which = input.byte();
  grader::for_each_exercise([&]<class Calls>() {
    if (which-- == 0) try_calls<Calls>(input);
  });
}

// Scratch grows with the square of a vector, and a matrix of S2 may have 2^20 rows without a vector of that
// length.
std::size_t fuzz::most_memory(std::size_t input) {
  return 100'000'000 + 100 * input;
}

std::vector<std::string> fuzz::seeds() {
  std::vector<std::string> all;
  int exercise = 0;
  grader::for_each_exercise([&]<class Calls>() {
    grader::for_each_call<Calls>([&]<int number>() { all.push_back(seed<Calls, number>(exercise)); });
    ++exercise;
  });
  return all;
}
