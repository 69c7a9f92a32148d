// STAFF ONLY. A worker that breaks the protocol of provided functions, for provided_test. The name of its
// object selects the way.
#include <unistd.h>

#include <filesystem>
#include <limits>

#include "grader/wire/channel.h"
#include "grader/wire/message.h"
#include "reference/H5/calls.h"
#include "reference/S1/calls.h"

namespace {

using namespace grader;

std::uint64_t nonce = 0;
Channel channel(3, 4);

template <class Calls>
MessageWriter call_of(int number) {
  MessageWriter call;
  call.put(std::string(Calls::id)).put(number);
  return call;
}

// Writes a system of n unknowns, but with another count of numbers.
MessageWriter conj_grad(int n, Eigen::Index given) {
  MessageWriter call = call_of<s1::Calls>(s1::Calls::number_of<s1::conj_grad>());
  call.put(0).put(n).put(n);  // the matrix: operator 0, its rows and columns
  for (int vector = 0; vector < 2; ++vector) encode(call, Eigen::VectorXd(Eigen::VectorXd::Ones(given)));
  return call.put(-1.0).put(std::numeric_limits<int>::max());
}

// Writes a strand of two particles, and velocities that no sweep corrects.
MessageWriter endless_sweeps() {
  MessageWriter call = call_of<h5::Calls>(h5::Calls::number_of<hair::correct_velocities>());
  hair::Strand strand;
  strand.mass = Eigen::VectorXd::Ones(2);
  strand.rest_length = Eigen::VectorXd::Ones(1);
  encode(call, strand);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(6), v = Eigen::VectorXd::Constant(6, 1e300);
  x[3] = 1;
  encode(call, x);
  call.put(-1.0).put(std::numeric_limits<int>::max());
  encode(call, v);
  return call.put(hair::kCorrectionScratch).put(0.0);
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

// Sends products with another definite matrix each time: no solution is ever reached.
void send_products_forever() {
  for (double scale = 2;; scale = scale < 100 ? scale + 0.3 : 2) {
    MessageReader question(receive().body);
    question.get<int>();
    std::vector<double> y = question.get_doubles();
    for (std::size_t i = 0; i < y.size(); ++i) y[i] *= i % 2 == 0 ? scale : 1 / scale;
    send_product(y);
  }
}

void solve_until_asked() {
  send(Kind::call, conj_grad(3, 3));
  receive();
}

void misbehave(const std::string& how) {
  if (how == "calls-what-is-not-provided") {
    MessageWriter call;
    send(Kind::call, call.put(std::string("H4")).put(0));
  } else if (how == "calls-what-is-not-there") {
    send(Kind::call, call_of<s1::Calls>(1000));
  } else if (how == "calls-before-the-first") {
    send(Kind::call, call_of<h5::Calls>(-1));
  } else if (how == "has-fewer-numbers-than-unknowns") {
    send(Kind::call, conj_grad(1 << 30, 3));
  } else if (how == "has-less-than-no-unknowns") {
    send(Kind::call, conj_grad(-1, 0));
  } else if (how == "calls-in-callbacks-forever") {
    for (;;) solve_until_asked();
  } else if (how == "throws-unasked") {
    send(Kind::callback_threw);
  } else if (how == "answers-unasked") {
    send_product({1, 2, 3});
  } else if (how == "answers-with-another-length") {
    solve_until_asked();
    send_product({1, 2, 3, 4});
  } else if (how == "is-done-in-a-callback") {
    solve_until_asked();
    send(Kind::done);
  } else if (how == "exits-in-a-callback") {
    solve_until_asked();
    _exit(0);
  } else if (how == "throws-in-a-callback") {
    solve_until_asked();
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
  receive();  // waits for its end
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
