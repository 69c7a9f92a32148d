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
  // Neither descriptor is owned.
  Channel(int in, int out) : in_(in), out_(out) {}

  // False if the other side is gone.
  bool send(Kind kind, std::uint64_t nonce, std::span<const std::byte> body = {});

  // The next message; nothing if the other side is gone. Blocks. Throws MalformedMessage for a body larger
  // than `limit` bytes.
  std::optional<Message> receive(std::size_t limit);

  int in() const { return in_; }

 private:
  int in_, out_;
};

}  // namespace grader
