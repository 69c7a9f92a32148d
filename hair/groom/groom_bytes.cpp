#include "hair/groom/groom_bytes.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"

namespace hair {

bool fits_float(double number) {
  return std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max());
}

GroomBytes::GroomBytes(std::string_view bytes, const std::string& name, Numbers numbers)
    : bytes_(bytes), name_(printable(name, 4096)), numbers_(numbers) {}

void GroomBytes::fail(const std::string& what) const {
  throw BadInput(name_ + ": " + what);
}

void GroomBytes::fail_at(std::size_t byte, const std::string& what) const {
  fail("byte " + std::to_string(byte) + ": " + what);
}

std::uint32_t GroomBytes::number(std::size_t at, int size) const {
  std::uint32_t value = 0;
  for (int i = 0; i < size; ++i)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes_[at + static_cast<std::size_t>(i)]))
             << (8 * i);
  return value;
}

float GroomBytes::real(std::size_t at, const std::string& what) const {
  const float value = std::bit_cast<float>(number(at));
  if (numbers_ == Numbers::finite && !std::isfinite(value))
    fail_at(at, what + " has a number that is not finite");
  return value;
}

Eigen::VectorXd GroomBytes::points(std::size_t at, std::size_t count, std::size_t strand) const {
  Eigen::VectorXd x(3 * static_cast<Eigen::Index>(count));
  for (Eigen::Index k = 0; k < x.size(); ++k, at += 4) {
    const float value = std::bit_cast<float>(number(at));
    if (numbers_ == Numbers::finite && !std::isfinite(value))
      fail_at(at, "strand " + std::to_string(strand) + ", point " + std::to_string(k / 3) +
                      ": has a number that is not finite");
    x[k] = static_cast<double>(value);
  }
  return x;
}

void put_number(std::string& bytes, std::uint32_t number, int size) {
  for (int i = 0; i < size; ++i) bytes.push_back(static_cast<char>(number >> (8 * i)));
}

void put_real(std::string& bytes, float number) {
  put_number(bytes, std::bit_cast<std::uint32_t>(number));
}

namespace {

void check_look(const GroomLook& look, std::size_t points) {
  for (const LookPart& part : parts_of(look)) {
    const std::string what = (part.of_each.empty() ? "" : "points' ") + std::string(part.name);
    if (!part.of_each.empty() && part.of_each.size() != part.size * points)
      throw BadInput("the groom has " + std::to_string(part.of_each.size()) + " numbers for its " + what +
                     "; " + std::to_string(part.size * points) + " are right");
    for (const std::span<const float> numbers : {part.of_all, part.of_each})
      for (const float number : numbers)
        if (!std::isfinite(number))
          throw BadInput("the groom's " + what + " has a number that is not finite");
  }
}

}  // namespace

void check_writable(const Groom& groom) {
  if (groom.strands.empty()) throw BadInput("the groom has no strands; a file has one at least");
  if (points_of(groom) > kMostGroomPoints)
    throw BadInput("the groom has " + std::to_string(points_of(groom)) + " points; a file has at most " +
                   std::to_string(kMostGroomPoints));
  for (std::size_t i = 0; i < groom.strands.size(); ++i) {
    const Eigen::VectorXd& x = groom.strands[i];
    const std::string which = "strand " + std::to_string(i) + " of the groom: ";
    if (points_of(x) < 1) throw BadInput(which + "has no points; one at least is right");
    for (const double number : x)
      if (!fits_float(number))
        throw BadInput(which + "has a number that is not finite, or too large for 32 bits");
  }
  check_look(groom.look, static_cast<std::size_t>(points_of(groom)));
}

}  // namespace hair
