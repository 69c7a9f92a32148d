// STAFF ONLY. The contents of a message: numbers in this machine's own format, one after the other; arrays
// with their length before them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace grader::inline wire {

// Means that a message has an invalid form. If it comes from a worker, the worker broke the rules.
class MalformedMessage : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

class MessageWriter {
 public:
  template <typename Number>
  requires std::is_arithmetic_v<Number> MessageWriter& put(Number value) {
    append(&value, sizeof value);
    return *this;
  }
  MessageWriter& put(std::span<const double> values);
  MessageWriter& put(const std::string& text);

  const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  void append(const void* data, std::size_t size);

  std::vector<std::byte> bytes_;
};

// Reads the values of a MessageWriter in the same order. Throws MalformedMessage if the message is too short.
class MessageReader {
 public:
  explicit MessageReader(std::vector<std::byte> bytes) : bytes_(std::move(bytes)) {}

  template <typename Number>
  requires std::is_arithmetic_v<Number> Number get() {
    Number value;
    std::memcpy(&value, take(sizeof value), sizeof value);
    return value;
  }
  std::vector<double> get_doubles();
  std::vector<double> get_doubles(std::size_t expected);  // throws MalformedMessage for another length
  std::string get_text();      // reads 1000 bytes at most, control characters as spaces: for untrusted
                               // senders
  std::string get_document();  // reads the whole text, unchanged: only for trusted senders
  void expect_end() const;

 private:
  const std::byte* take(std::size_t size);

  std::vector<std::byte> bytes_;
  std::size_t at_ = 0;
};

// Computes y = A x with an object of the calling side, of operator number `which`. Sets the size of y.
// Returns false to stop the request. Throws MalformedMessage for an unknown operator, or for another length
// of x.
using Products = std::function<bool(int which, const std::vector<double>& x, std::vector<double>& y)>;

}  // namespace grader::wire
