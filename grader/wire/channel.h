// STAFF ONLY. Messages over two pipes. The suite sends requests, the worker answers:
//
//   suite -> worker           worker -> suite
//
//                             hello, once, when it is ready | cannot_load
//   request(function, ...)
//   product_result(...)       product(operator, x), during the request
//   stop, for the request     denied(system call), during the request
//                             done(...) | stopped | not_implemented | threw | out_of_memory
//                             | left(exit code)
//
// During the request the worker may also call a function of a prerequisite, which the suite provides
// (grader/judge/student/provided.h). Then the suite may ask for products with the caller's object:
//
//                             call(function, ...)
//   callback(operator, x)     callback_result(doubles) | callback_threw, which ends the call
//   call_result(...)
//
// Each request carries a random number (nonce). Every message for this request must carry the same number.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace grader::inline wire {

// New kinds come last: attacks of the sample class contain these numbers.
enum class Kind : std::uint32_t {
  hello = 0x68616972,
  cannot_load,     // text
  request,         // int function, then its arguments
  product,         // int operator, doubles x
  product_result,  // doubles
  stop,            // enough products: stops this request
  stopped,
  done,             // the function's results
  not_implemented,  // text
  threw,            // text
  out_of_memory,
  denied,           // int system call; the request goes on
  call,             // int function, then its arguments
  call_result,      // the function's results
  callback,         // int operator, doubles x
  callback_result,  // doubles
  callback_threw,   // an exception leaves the call; the request goes on
  left,             // int, an exit code above 127; the worker ends
};

struct Message {
  Kind kind;
  std::uint64_t nonce;
  std::vector<std::byte> body;
};

class Channel {
 public:
  // Waits until `descriptor` is ready for `events` (POLLIN, POLLOUT); returns false to give up.
  using Wait = std::function<bool(int descriptor, short events)>;

  // Does not own the descriptors. Without `wait`, sending and receiving block. With it, they call it before
  // every step, and `out` must be non-blocking, so that the other side can't block us by sending half a
  // message or by not reading.
  Channel(int in, int out, Wait wait = {}) : in_(in), out_(out), wait_(std::move(wait)) {}

  // Returns false if the other side is gone, or `wait` gave up.
  bool send(Kind kind, std::uint64_t nonce, std::span<const std::byte> body = {});

  // Returns the next message; nothing if the other side is gone, or `wait` gave up. Throws MalformedMessage
  // for a body larger than `limit` bytes.
  std::optional<Message> receive(std::size_t limit);

 private:
  bool read_fully(void* to, std::size_t size);

  int in_, out_;
  Wait wait_;
};

}  // namespace grader::wire
