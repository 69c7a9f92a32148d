// STAFF ONLY. A worker that does not keep to the protocol of lent functions, for lending_test. The name of the object
// that it should load says how.
#include <unistd.h>

#include <filesystem>
#include <limits>

#include "grader/wire/channel.h"
#include "grader/wire/lent_functions.h"
#include "grader/wire/message.h"

namespace {

using namespace grader;

std::uint64_t nonce = 0;
Channel channel(3, 4);

MessageWriter conj_grad(int n, std::size_t given) {
  MessageWriter call;
  const std::vector<double> b(given, 1.0);
  call.put(kLentConjGrad).put(n).put(-1.0).put(std::numeric_limits<int>::max());
  return call.put(std::span<const double>(b));
}

// A strand of two particles, and velocities that no sweep makes right.
MessageWriter endless_sweeps() {
  MessageWriter call;
  const std::vector<double> two(2, 1.0), one(1, 1.0), x = {0, 0, 0, 1, 0, 0}, v(6, 1e300);
  call.put(kLentCorrectVelocities).put(std::span<const double>(two)).put(std::span<const double>(one));
  call.put(1.0).put(1.0).put(1.0).put(std::uint8_t{0}).put(0.0).put(0.0).put(1.0);
  call.put(-1.0).put(-1);
  return call.put(std::span<const double>(x)).put(std::span<const double>(v));
}

void send(Kind kind, const MessageWriter& body = {}) {
  if (!channel.send(kind, nonce, body.bytes())) _exit(0);
}

Message receive() {
  auto message = channel.receive(std::size_t{1} << 24);
  if (!message) _exit(0);
  nonce = message->nonce;
  return std::move(*message);
}

void send_product(const std::vector<double>& y) {
  MessageWriter result;
  send(Kind::callback_result, result.put(std::span<const double>(y)));
}

// Products with another definite matrix each time: no solution is ever reached.
void send_products_forever() {
  for (double scale = 2;; scale = scale < 100 ? scale + 0.3 : 2) {
    MessageReader question(receive().body);
    question.get<int>();
    std::vector<double> y = question.get_doubles();
    for (std::size_t i = 0; i < y.size(); ++i) y[i] *= i % 2 == 0 ? scale : 1 / scale;
    send_product(y);
  }
}

void misbehave(const std::string& how) {
  if (how == "calls-what-is-not-lent") {
    MessageWriter call;
    send(Kind::call, call.put(kLentSolveImplicit));
  } else if (how == "calls-what-is-not-there") {
    MessageWriter call;
    send(Kind::call, call.put(1000));
  } else if (how == "has-fewer-numbers-than-unknowns") {
    send(Kind::call, conj_grad(1 << 30, 3));
  } else if (how == "has-less-than-no-unknowns") {
    send(Kind::call, conj_grad(-1, 0));
  } else if (how == "calls-in-callbacks-forever") {
    for (;;) {
      send(Kind::call, conj_grad(3, 3));
      receive();
    }
  } else if (how == "throws-unasked") {
    send(Kind::callback_threw);
  } else if (how == "answers-unasked") {
    send_product({1, 2, 3});
  } else if (how == "answers-with-another-length") {
    send(Kind::call, conj_grad(3, 3));
    receive();
    send_product({1, 2, 3, 4});
  } else if (how == "is-done-in-a-callback") {
    send(Kind::call, conj_grad(3, 3));
    receive();
    send(Kind::done);
  } else if (how == "exits-in-a-callback") {
    send(Kind::call, conj_grad(3, 3));
    receive();
    _exit(0);
  } else if (how == "throws-in-a-callback") {
    send(Kind::call, conj_grad(3, 3));
    receive();
    send(Kind::callback_threw);
    MessageWriter text;
    send(Kind::threw, text.put(std::string("as it may")));
    return;
  } else if (how == "solves-forever") {
    send(Kind::call, conj_grad(3, 3));
    send_products_forever();
  } else if (how == "sweeps-forever") {
    send(Kind::call, endless_sweeps());
    receive();
    send(Kind::done);
    return;
  }
  receive();  // to be ended there
}

}  // namespace

int main(int argc, char* argv[]) {
  if (argc < 5) return 2;
  send(Kind::hello);
  for (;;) {
    receive();
    misbehave(std::filesystem::path(argv[argc - 2]).stem().string());
  }
}
