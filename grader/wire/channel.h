// STAFF ONLY. Messages over two pipes. One side asks, the other answers:
//
//   suite -> worker  request(function, ...)        worker -> suite  hello, once, when it is ready
//                    product_result(...)                            product(operator, x)  while it works on
//                    the request stop                                           done(...) | not_implemented |
//                    threw | out_of_memory
//                                                                   | denied | cannot_load
//
// Each request carries a number drawn at random, and so must all that is sent for it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace grader {

enum class Kind : std::uint32_t {
  hello = 0x68616972,
  cannot_load,     // text
  request,         // int function, then what the function needs
  product,         // int operator, doubles x
  product_result,  // doubles
  stop,            // enough products: give up on this request
  stopped,
  done,             // what the function returned
  not_implemented,  // text
  threw,            // text
  out_of_memory,
  denied,  // int system call; the request goes on
};

struct Message {
  Kind kind;
  std::uint64_t nonce;
  std::vector<std::byte> body;
};

class Channel {
 public:
  // Waits until `descriptor` is ready for `events` (POLLIN, POLLOUT); false to give up.
  using Wait = std::function<bool(int descriptor, short events)>;

  // Neither descriptor is owned. Without `wait` sending and receiving block; with it they ask it before every
  // step, and `out` must not block, so that the other side can hold up nothing by sending half a message or
  // by reading none.
  Channel(int in, int out, Wait wait = {}) : in_(in), out_(out), wait_(std::move(wait)) {}

  // False if the other side is gone, or `wait` gave up.
  bool send(Kind kind, std::uint64_t nonce, std::span<const std::byte> body = {});

  // The next message; nothing if the other side is gone, or `wait` gave up. Throws MalformedMessage for a
  // body larger than `limit` bytes.
  std::optional<Message> receive(std::size_t limit);

 private:
  bool read_fully(void* to, std::size_t size);

  int in_, out_;
  Wait wait_;
};

}  // namespace grader
