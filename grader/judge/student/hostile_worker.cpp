// STAFF ONLY. A worker that breaks the rules, for the tests of Student: the name of the last object in its
// command selects the way.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "grader/wire/channel.h"
#include "grader/wire/message.h"

namespace {

using namespace grader;

constexpr std::size_t kMost = 1 << 20;

[[noreturn]] void sleep_on() {
  for (;;) sleep(1000);
}

void answer(Channel& channel, const std::string& way, std::uint64_t nonce) {
  const auto product = [&] {
    MessageWriter message;
    message.put(0).put(std::vector<double>(10, 1.0));
    channel.send(Kind::product, nonce, message.bytes());
  };
  if (way == "right") {
    product();
    channel.receive(kMost);
    channel.send(Kind::done, nonce);
  } else if (way == "tries-calls") {
    MessageWriter message;
    message.put(41);  // socket
    for (int i = 0; i < 100000; ++i) channel.send(Kind::denied, nonce, message.bytes());
    channel.send(Kind::done, nonce);
  } else if (way == "floods") {
    for (;;) {
      product();
      channel.receive(kMost);
    }
  } else if (way == "leaves-late") {
    channel.send(Kind::done, nonce);
    usleep(600000);
    _exit(0);
  } else if (way == "crashes") {
    _exit(3);
  } else if (way == "naps-and-crashes") {
    usleep(150000);
    _exit(3);
  } else if (way == "sleeps") {
    sleep_on();
  } else if (way == "half") {
    if (write(4, "half", 4) == 4) sleep_on();
  } else if (way == "huge") {
    const std::uint64_t header[] = {static_cast<std::uint64_t>(Kind::done), nonce, std::uint64_t{1} << 40};
    if (write(4, header, sizeof header) > 0) sleep_on();
  } else if (way == "another-nonce") {
    channel.send(Kind::done, nonce + 1);
  }
}

}  // namespace

int main(int argc, char* argv[]) {
  if (argc < 3) return 2;
  const std::string way = std::filesystem::path(argv[argc - 2]).stem();
  Channel channel(3, 4);
  if (way == "speaks-first") channel.send(Kind::done, 0);
  channel.send(Kind::hello, 0);
  while (std::optional<Message> request = channel.receive(kMost)) answer(channel, way, request->nonce);
}
