// The bytes of a groom's file, little-endian: reads and writes them. An error names the file and the byte.
#pragma once

#include <string>
#include <string_view>

#include "hair/groom/groom.h"

namespace hair {

// The limit for a file.
inline constexpr std::size_t kMostGroomBytes = std::size_t{1} << 30;

// True if 32 bits can hold a number, at least nearly.
bool fits_float(double number);

class GroomBytes {
 public:
  GroomBytes(std::string_view bytes, const std::string& name, Numbers numbers);

  // Both throw BadInput: "NAME: what", "NAME: byte 17: what".
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail_at(std::size_t byte, const std::string& what) const;

  std::size_t size() const { return bytes_.size(); }
  bool begins_with(std::string_view start) const { return bytes_.substr(0, start.size()) == start; }
  std::string_view part(std::size_t at, std::size_t size) const { return bytes_.substr(at, size); }

  // Reads `size` bytes, or 4. The caller has checked that they are there.
  std::uint32_t number(std::size_t at, int size = 4) const;
  // Throws BadInput for a number that is not finite, unless such numbers are kept; `what` names the number.
  float real(std::size_t at, const std::string& what) const;

  // The points of a strand, f32 x 3 each. `strand` is its number, for error messages.
  Eigen::VectorXd points(std::size_t at, std::size_t count, std::size_t strand) const;

 private:
  std::string_view bytes_;
  std::string name_;
  Numbers numbers_;
};

void put_number(std::string& bytes, std::uint32_t number, int size = 4);
void put_real(std::string& bytes, float number);

// Every writer calls this before it writes. Throws BadInput for a groom without strands, for one with too
// many points, for a strand without points, and for a number that 32 bits can't hold.
void check_writable(const Groom& groom);

}  // namespace hair
