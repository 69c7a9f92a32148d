// Grooms as .hair files. Source: C. Yuksel, "HAIR Model Files", www.cemyuksel.com/research/hairmodels. All
// little-endian:
//
//   128 bytes   "HAIR"; u32 strands, points, which arrays there are, segments of a strand; f32 thickness,
//               transparency, colour[3]; 88 bytes of text
//   then, for each bit of the third number:
//   1           u16 for each strand, its number of segments; without it all have those of the header
//   2           f32 x 3 for each point, strand after strand, from the root: this one must be there
//   4, 8, 16    f32 thickness, f32 transparency, f32 x 3 colour of each point, which are passed over
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hair/head/groom.h"

namespace hair {

// Of all points together, and of bytes in a file that holds as many with all arrays.
inline constexpr long kMostGroomPoints = 10'000'000;
inline constexpr std::size_t kMostGroomBytes = 128 + 34 * static_cast<std::size_t>(kMostGroomPoints);

// Throws BadInput, which begins with `name`: not of this form, of another length than its header says, a strand of
// fewer than two points, two neighbours in the same place, or a number that is not finite.
Groom parse_hair_file(std::string_view bytes, const std::string& name);
Groom read_hair_file(const std::filesystem::path& file);

}  // namespace hair
