// A digest of numbers, bit by bit: FNV-1a, 64 bits (G. Fowler, L. C. Noll, K.-P. Vo; RFC 9923). It is not
// cryptographic: collisions are easy to construct.
#pragma once

#include <Eigen/Core>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace hair {

class Digest {
 public:
  Digest& add(std::uint64_t bits) {
    for (int i = 0; i < 64; i += 8) add_byte((bits >> i) & 0xff);
    return *this;
  }
  Digest& add(double value) { return add(std::bit_cast<std::uint64_t>(value)); }
  Digest& add(int value) { return add(static_cast<std::uint64_t>(static_cast<std::int64_t>(value))); }
  Digest& add(bool value) { return add(static_cast<std::uint64_t>(value)); }

  // Adds the size first, so that later values can't be mistaken for a part of this vector.
  template <typename Derived>
  Digest& add(const Eigen::MatrixBase<Derived>& values) {
    add(static_cast<std::uint64_t>(values.size()));
    for (Eigen::Index i = 0; i < values.size(); ++i) add(static_cast<double>(values[i]));
    return *this;
  }
  Digest& add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    for (const char byte : text) add_byte(static_cast<unsigned char>(byte));
    return *this;
  }

  // 16 hexadecimal digits.
  std::string text() const {
    std::array<char, 17> digits;
    std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(sum_));
    return digits.data();
  }

 private:
  void add_byte(std::uint64_t byte) { sum_ = (sum_ ^ byte) * 0x100000001b3; }

  std::uint64_t sum_ = 0xcbf29ce484222325;
};

}  // namespace hair
