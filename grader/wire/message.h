// STAFF ONLY. What a message is made of: numbers in this machine's own form, one after the other; arrays with
// their length before them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace grader {

// A message that is not of its form. From a worker, that is a broken rule.
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

// Reads what a MessageWriter wrote, in its order. Throws MalformedMessage where there is less than asked for.
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
  std::vector<double> get_doubles(std::size_t expected);  // MalformedMessage for another number of them
  std::string get_text();  // its first 1000 bytes, control characters as spaces: the sender may be anybody
  std::string get_document();  // all of a text, as it is: from a sender who is trusted
  void expect_end() const;

 private:
  const std::byte* take(std::size_t size);

  std::vector<std::byte> bytes_;
  std::size_t at_ = 0;
};

}  // namespace grader
