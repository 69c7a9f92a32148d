// STAFF ONLY. Writes and reads the values of a message.
#include "grader/wire/message.h"

#include <algorithm>

namespace grader::inline wire {

MessageWriter& MessageWriter::put(std::span<const double> values) {
  put(static_cast<std::uint64_t>(values.size()));
  append(values.data(), values.size_bytes());
  return *this;
}

MessageWriter& MessageWriter::put(const std::string& text) {
  put(static_cast<std::uint64_t>(text.size()));
  append(text.data(), text.size());
  return *this;
}

void MessageWriter::append(const void* data, std::size_t size) {
  const std::byte* begin = static_cast<const std::byte*>(data);
  bytes_.insert(bytes_.end(), begin, begin + size);
}

std::vector<double> MessageReader::get_doubles() {
  const auto count = get<std::uint64_t>();
  if (count > (bytes_.size() - at_) / sizeof(double))
    throw MalformedMessage("an array of " + std::to_string(count) + " numbers in a message that is shorter");
  std::vector<double> values(count);
  if (count > 0) std::memcpy(values.data(), take(count * sizeof(double)), count * sizeof(double));
  return values;
}

std::vector<double> MessageReader::get_doubles(std::size_t expected) {
  std::vector<double> values = get_doubles();
  if (values.size() != expected)
    throw MalformedMessage("an array of " + std::to_string(values.size()) + " numbers; expected " +
                           std::to_string(expected));
  return values;
}

std::string MessageReader::get_document() {
  const auto size = get<std::uint64_t>();
  if (size > bytes_.size() - at_) throw MalformedMessage("a text that is longer than its message");
  if (size == 0) return {};
  return {reinterpret_cast<const char*>(take(size)), size};
}

std::string MessageReader::get_text() {
  constexpr std::uint64_t kMost = 1000;
  const auto size = get<std::uint64_t>();
  if (size > bytes_.size() - at_) throw MalformedMessage("a text that is longer than its message");
  if (size == 0) return {};
  std::string text(reinterpret_cast<const char*>(take(size)), std::min(size, kMost));
  std::replace_if(
      text.begin(), text.end(), [](unsigned char letter) { return letter < ' ' || letter == 0x7f; }, ' ');
  return text;
}

void MessageReader::expect_end() const {
  if (at_ != bytes_.size())
    throw MalformedMessage(std::to_string(bytes_.size() - at_) + " bytes too many in a message");
}

const std::byte* MessageReader::take(std::size_t size) {
  if (size > bytes_.size() - at_)
    throw MalformedMessage("a message ends after " + std::to_string(bytes_.size()) + " bytes, " +
                           std::to_string(size - (bytes_.size() - at_)) + " too soon");
  const std::byte* data = bytes_.data() + at_;
  at_ += size;
  return data;
}

}  // namespace grader::wire
