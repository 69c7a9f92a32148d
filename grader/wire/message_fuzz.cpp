// STAFF ONLY. Reads hostile bytes of a worker as a stream of messages. Messages that were read can be sent,
// and arrive unchanged. Bodies of calls are read by calls_fuzz.cpp.
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

using grader::Message;

constexpr std::size_t kLongestMessage = 4096;

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

}  // namespace

// Sends all bytes at once, and then the other side is gone.
void fuzz::try_input(std::string_view bytes) {
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

// A stream has at most one announced message, twice.
std::size_t fuzz::most_memory(std::size_t input) {
  return 10'000 + 4 * kLongestMessage + 12 * input;
}

std::vector<std::string> fuzz::seeds() {
  // The stream has two messages: kind, nothing, a number, the body's length, the body.
  std::string stream;
  for (const std::string& body : {std::string("12345678"), std::string()}) {
    const std::uint32_t kind[] = {static_cast<std::uint32_t>(grader::Kind::done), 0};
    const std::uint64_t rest_of_header[] = {99, body.size()};
    stream.append(reinterpret_cast<const char*>(kind), sizeof kind);
    stream.append(reinterpret_cast<const char*>(rest_of_header), sizeof rest_of_header);
    stream += body;
  }
  return {stream};
}
