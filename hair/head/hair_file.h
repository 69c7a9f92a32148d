// Grooms as .hair files. Source: C. Yuksel, "HAIR Model Files", www.cemyuksel.com/research/hairmodels. All
// little-endian:
//
//   128 bytes   "HAIR"; u32 strands, points, bits of the arrays present, segments of a strand; f32 thickness,
//               transparency, colour[3]; 88 bytes of text
//   then, for each bit of the third number:
//   1           u16 for each strand, its number of segments; without it, all have the header's number
//   2           f32 x 3 for each point, strand after strand, from the root; this array is required
//   4, 8, 16    f32 thickness, f32 transparency, f32 x 3 colour of each point; ignored
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hair/head/groom.h"

namespace hair {

// The limit for all points together, and the size of a file with that many points and all arrays.
inline constexpr long kMostGroomPoints = 10'000'000;
inline constexpr std::size_t kMostGroomBytes = 128 + 34 * static_cast<std::size_t>(kMostGroomPoints);

// Throws BadInput with a message that begins with `name`, if the file has another format, a length that its
// header contradicts, a strand of fewer than two points, two neighbours at the same place, or a number that
// is not finite.
Groom parse_hair_file(std::string_view bytes, const std::string& name);
Groom read_hair_file(const std::filesystem::path& file);

}  // namespace hair
