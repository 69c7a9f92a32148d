// A .hair file, made by hand, for tests: its numbers may contradict each other.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace hair {

struct MadeHairFile {
  std::uint32_t strands = 2, points = 5, arrays = 3, segments = 0;
  std::vector<std::uint16_t> own = {1, 2};
  std::vector<float> numbers = {0, 0, 0, 1, 0, 0, /* strand 1 */ 0, 1, 0, 0, 1, 1, 0, 1, 2};
  std::string rest = {};

  std::string bytes() const {
    std::string all = "HAIR";
    const auto put = [&](std::uint32_t value, int size) {
      for (int i = 0; i < size; ++i) all.push_back(static_cast<char>(value >> (8 * i)));
    };
    for (const std::uint32_t value : {strands, points, arrays, segments}) put(value, 4);
    all.resize(128, '\0');
    for (const std::uint16_t value : own) put(value, 2);
    for (const float value : numbers) put(std::bit_cast<std::uint32_t>(value), 4);
    return all + rest;
  }
};

}  // namespace hair
