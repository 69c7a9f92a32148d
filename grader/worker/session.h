// STAFF ONLY. One request, as the server of an exercise sees it. Each server is a separate shared object, made of serve.cpp.in. It is
// loaded after the student's object and calls it through the given headers.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <vector>

#include "grader/wire/channel.h"
#include "grader/wire/message.h"

namespace grader {

// Calls of the worker's malloc and of what is like it, while it counts.
struct Allocations {
  std::atomic<bool> counting = false;
  std::atomic<int> count = 0;
};

// The suite stopped the request: this exception unwinds the student's function.
struct Stopped {};

class Session {
 public:
  // `allocations`: null where nothing can be counted.
  Session(Channel& channel, std::uint64_t nonce, MessageReader asked, Allocations* allocations)
      : request(std::move(asked)), channel_(channel), nonce_(nonce), allocations_(allocations) {}

  // Asks the suite for the product of its operator number `which` with x.
  void product(int which, std::span<const double> x, std::span<double> result);

  // Computes what the suite asks of a caller's object: y, from x.
  using Callback = std::function<void(int which, std::vector<double>& x, std::vector<double>& y)>;

  // Calls a function that the suite provides, grader/judge/student/provided.h. An exception of `callback` ends the call.
  MessageReader call(const MessageWriter& arguments, const Callback& callback);

  // Calls a function of the student's that allocates nothing, by its contract, and counts what it allocates.
  template <typename Function>
  decltype(auto) counted(Function&& call) {
    const Counted during(*this);
    return call();
  }

  // How often a counted function allocated, at the most.
  int allocations() const { return most_allocations_; }

  // While it lives, nothing is counted: what a function of ours allocates, which the student's calls.
  class Uncounted {
   public:
    explicit Uncounted(const Session& session)
        : allocations_(session.allocations_),
          before_(allocations_ != nullptr && allocations_->counting.exchange(false)) {}
    Uncounted(const Uncounted&) = delete;
    Uncounted& operator=(const Uncounted&) = delete;
    ~Uncounted() {
      if (allocations_ != nullptr) allocations_->counting = before_;
    }

   private:
    Allocations* allocations_;
    bool before_;
  };

  MessageReader request;
  MessageWriter reply;
  const void* served_force = nullptr;  // the force that the suite holds in this request, if there is one

 private:
  class Counted {
   public:
    explicit Counted(Session& session) : session_(session) {
      if (session_.allocations_ == nullptr) return;
      session_.allocations_->count = 0;
      session_.allocations_->counting = true;
    }
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;
    ~Counted() {
      if (session_.allocations_ == nullptr) return;
      session_.allocations_->counting = false;
      session_.most_allocations_ = std::max(session_.most_allocations_, session_.allocations_->count.load());
    }

   private:
    Session& session_;
  };

  Message receive(std::size_t limit);

  Channel& channel_;
  std::uint64_t nonce_;
  Allocations* allocations_;
  int most_allocations_ = 0;
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

// The variable that each object of provided functions defines: the session of the present request, which contracts have
// no argument for.
using ProvidedSession = Session*;
inline constexpr const char* kProvidedSessionName = "provided_session";

}  // namespace grader
