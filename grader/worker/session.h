// STAFF ONLY. One request, as the server of an exercise sees it. Each server is a separate shared object,
// made of serve.cpp.in. It is loaded after the student's object and calls it through the given headers.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <vector>

#include "grader/wire/channel.h"
#include "grader/wire/message.h"

namespace grader::inline worker {

// The suite stopped the request: this exception unwinds the student's function.
struct Stopped {};

class Session {
 public:
  Session(Channel& channel, std::uint64_t nonce, MessageReader asked)
      : request(std::move(asked)), channel_(channel), nonce_(nonce) {}

  // Asks the suite for the product of its operator number `which` with x.
  void product(int which, std::span<const double> x, std::span<double> result);

  // Computes y from x with the caller's object, for the suite.
  using Callback = std::function<void(int which, std::vector<double>& x, std::vector<double>& y)>;

  // Calls a function that the suite provides, grader/judge/student/provided.h. An exception of `callback`
  // ends the call.
  MessageReader call(const MessageWriter& arguments, const Callback& callback);

  MessageReader request;
  MessageWriter reply;
  const void* served_force = nullptr;  // is the force that the suite holds in this request, or null

 private:
  Message receive(std::size_t limit);

  Channel& channel_;
  std::uint64_t nonce_;
};

// Holds a copy of `values` that ends directly before a protected page.
class GuardedBuffer {
 public:
  explicit GuardedBuffer(const std::vector<double>& values);
  GuardedBuffer(const GuardedBuffer&) = delete;
  GuardedBuffer& operator=(const GuardedBuffer&) = delete;
  ~GuardedBuffer();

  double* data() { return values_.data(); }
  std::span<const double> values() const { return values_; }

 private:
  std::span<std::byte> pages_;
  std::span<double> values_;
};

// Each server defines this function: it reads the session's request, calls the student's function, and writes
// the session's reply.
using Server = void (*)(Session& session);
inline constexpr const char* kServerName = "serve";

// Each object of provided functions defines this variable: the session of the present request, since
// contracts have no argument for it.
using ProvidedSession = Session*;
inline constexpr const char* kProvidedSessionName = "provided_session";

}  // namespace grader::worker
