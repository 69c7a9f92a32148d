// `hairlab convert`, `hairlab info` and `hairlab groom` without their command lines.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace hair {

struct ConvertOptions {
  std::filesystem::path in, out;
  double scale = 1;
  long every = 1;
  int points = 0;  // per strand; 0: unchanged
};

struct GrowOptions {
  std::string style, head = "bust";  // or "ellipsoid"
  std::filesystem::path out;
  int strands = 10'000;
  int points = 0;  // per strand; 0: the style's
  std::uint64_t seed = 1;
};

// All return the program's exit code.
int convert_groom(const ConvertOptions& options);
int show_groom(const std::filesystem::path& file);
int write_grown_groom(const GrowOptions& options);

}  // namespace hair
