// STAFF ONLY. Decodes the points of a motion's file, as a page does.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "particles/vectors.h"

namespace hair {

inline std::string bytes_of_base64(const std::string& text) {
  static const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, held = 0;
  for (const char letter : text) {
    if (letter == '=') break;
    bits = bits << 6 | static_cast<unsigned>(letters.find(letter));
    if ((held += 6) < 8) continue;
    held -= 8;
    bytes += static_cast<char>(bits >> held & 255U);
  }
  return bytes;
}

// bytes: those of the motion's data.
inline Eigen::Vector3d point_of(const nlohmann::json& motion, const std::string& bytes, std::size_t frame,
                                std::size_t point) {
  Eigen::Vector3d at;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t i = 2 * (3 * (frame * motion["points"].get<std::size_t>() + point) + axis);
    const auto byte = [&](std::size_t place) { return static_cast<unsigned char>(bytes.at(place)); };
    const double low = motion["low"][axis], high = motion["high"][axis];
    at[static_cast<int>(axis)] = low + (high - low) * (byte(i) + 256U * byte(i + 1)) / 65535;
  }
  return at;
}

}  // namespace hair
