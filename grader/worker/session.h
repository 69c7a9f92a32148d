// STAFF ONLY. One request, as the server of an exercise sees it. Each server is a separate shared object,
// grader/worker/serve_<id>.cpp. It is loaded after the student's object and calls it through the given
// headers.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "grader/wire/channel.h"
#include "grader/wire/message.h"
#include "solver/linearSolver.h"

namespace grader {

// The suite stopped the request: this exception unwinds the student's function.
struct Stopped {};

class Session {
 public:
  Session(Channel& channel, std::uint64_t nonce, MessageReader asked)
      : request(std::move(asked)), channel_(channel), nonce_(nonce) {}

  // Asks the suite for the product of its operator number `which` with x.
  void product(int which, std::span<const double> x, std::span<double> result);

  MessageReader request;
  MessageWriter reply;

 private:
  Channel& channel_;
  std::uint64_t nonce_;
};

// A matrix that the suite holds. A product whose output overlaps its input, which no contract allows, is NaN: nobody
// has to tell the suite.
class ServedMatrix : public implicitMatrix {
 public:
  ServedMatrix(Session& session, int which, int rows, int cols)
      : session_(session), which_(which), rows_(rows), cols_(cols) {}

  void matVecMult(double x[], double b[]) override;

 private:
  Session& session_;
  int which_, rows_, cols_;
};

// A copy of `values` that ends directly before a protected page.
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

// The function that each server defines: it reads the session's request, calls the student's function, and
// writes the session's reply.
using Server = void (*)(Session& session);
inline constexpr const char* kServerName = "serve";

}  // namespace grader
