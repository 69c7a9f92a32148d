// STAFF ONLY. Reads hostile bytes of a worker: as a stream of messages, and as the body of one that a script
// reads. The first byte of the input is the script's length, then comes the script, then the body. Values
// that were read can be sent, and arrive unchanged.
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>

#include "grader/wire/channel.h"
#include "grader/wire/message.h"
#include "hair/io/fuzz/fuzz.h"

namespace {

using grader::Message, grader::MessageReader, grader::MessageWriter;
using Bytes = std::vector<std::byte>;

constexpr std::size_t kLongestMessage = 4096;

Bytes bytes_of(std::string_view text) {
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return {begin, begin + text.size()};
}

// Names a step of a script by its low four bits; the others are a length.
enum Step : unsigned char { an_int, a_double, a_byte, doubles, as_many_doubles, a_text, a_document, the_end };

void read_text(MessageReader& reader, MessageWriter& copy) {
  const std::string said = reader.get_text();
  fuzz::expect(said.size() <= 1000, "a text has at most 1000 bytes");
  if (!said.empty()) fuzz::expect_readable(said);
  copy.put(said);
}

// Reads by the script, and writes the values that it read.
void play(std::string_view script, MessageReader& reader, MessageWriter& copy) {
  for (const char c : script) {
    const auto step = static_cast<unsigned char>(c);
    const int length = step >> 4;
    switch (step & 15) {
      case an_int:
        copy.put(reader.get<int>());
        break;
      case a_double:
        copy.put(reader.get<double>());
        break;
      case a_byte:
        copy.put(reader.get<std::uint8_t>());
        break;
      case doubles:
        copy.put(std::span<const double>(reader.get_doubles()));
        break;
      case as_many_doubles:
        copy.put(std::span<const double>(reader.get_doubles(static_cast<std::size_t>(length))));
        break;
      case a_text:
        read_text(reader, copy);
        break;
      case a_document:
        copy.put(reader.get_document());
        break;
      default:
        reader.expect_end();
    }
  }
}

void try_body(std::string_view script, const Bytes& body) {
  MessageWriter first, second;
  try {
    MessageReader reader(body);
    play(script, reader, first);
  } catch (const grader::MalformedMessage& error) {
    fuzz::expect_readable(error.what());
    return;
  }
  MessageReader reader(first.bytes());
  play(script, reader, second);
  reader.expect_end();
  fuzz::expect(first.bytes() == second.bytes(), "what is sent arrives as it was");
}

class Pipe {
 public:
  Pipe() {
    if (pipe(ends_) != 0) throw std::runtime_error("no pipe");
  }
  ~Pipe() {
    close(ends_[0]);
    close_in();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int out() const { return ends_[0]; }
  int in() const { return ends_[1]; }
  void close_in() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  int ends_[2];
};

void expect_sent(const Message& message) {
  Pipe other;
  grader::Channel channel(other.out(), other.in());
  fuzz::expect(channel.send(message.kind, message.nonce, message.body), "a message is sent");
  const std::optional<Message> arrived = channel.receive(kLongestMessage);
  fuzz::expect(arrived && arrived->kind == message.kind && arrived->nonce == message.nonce &&
                   arrived->body == message.body,
               "a message arrives as it was");
}

// Sends all bytes at once, and then the other side is gone.
void try_stream(std::string_view bytes) {
  // A pipe holds this while nobody reads.
  constexpr std::size_t most = 65536;
  if (bytes.size() > most) return;
  Pipe hostile;
  if (write(hostile.in(), bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
    throw std::runtime_error("the pipe is full");
  hostile.close_in();
  grader::Channel channel(hostile.out(), -1);
  try {
    while (const std::optional<Message> message = channel.receive(kLongestMessage)) {
      fuzz::expect(message->body.size() <= std::min(kLongestMessage, bytes.size()), "a body is bounded");
      expect_sent(*message);
    }
  } catch (const grader::MalformedMessage& error) {
    fuzz::expect_readable(error.what());
  }
}

}  // namespace

void fuzz::try_input(std::string_view bytes) {
  try_stream(bytes);
  if (bytes.empty()) return;
  const auto length = std::min<std::size_t>(static_cast<unsigned char>(bytes[0]), bytes.size() - 1);
  try_body(bytes.substr(1, length), bytes_of(bytes.substr(1 + length)));
}

// Counts the body, its values, and two texts that grow to twice their size. A stream has at most one
// announced message, twice.
std::size_t fuzz::most_memory(std::size_t input) {
  return 10'000 + 4 * kLongestMessage + 12 * input;
}

std::vector<std::string> fuzz::seeds() {
  std::vector<std::string> all;
  const auto add = [&](const std::string& script, const MessageWriter& body) {
    const auto* text = reinterpret_cast<const char*>(body.bytes().data());
    all.push_back(static_cast<char>(script.size()) + script + std::string(text, body.bytes().size()));
  };
  const std::vector<double> three = {1, -0.0, 1e300};
  add({an_int, a_double, a_byte, the_end}, MessageWriter().put(7).put(2.5).put(std::uint8_t{1}));
  add({doubles, as_many_doubles + (3 << 4), a_text, a_document, the_end},
      MessageWriter().put(three).put(three).put(std::string("a\ntext")).put(std::string("{}")));

  // The stream has two messages: kind, nothing, a number, the body's length, the body.
  std::string stream;
  for (const std::string& body : {std::string("12345678"), std::string()}) {
    const std::uint32_t kind[] = {static_cast<std::uint32_t>(grader::Kind::done), 0};
    const std::uint64_t rest_of_header[] = {99, body.size()};
    stream.append(reinterpret_cast<const char*>(kind), sizeof kind);
    stream.append(reinterpret_cast<const char*>(rest_of_header), sizeof rest_of_header);
    stream += body;
  }
  all.push_back(stream);
  return all;
}
