// Grooms as .hair files. Source: C. Yuksel, "HAIR Model Files", www.cemyuksel.com/research/hairmodels. All
// little-endian:
//
//   128 bytes   "HAIR"; u32 strands, points, bits of the arrays present, segments of a strand; f32 thickness,
//               transparency, colour[3]; 88 bytes of text
//   then, for each bit of the third number:
//   1           u16 for each strand, its number of segments; without it, all have the header's number
//   2           f32 x 3 for each point, strand after strand, from the root; this array is required
//   4, 8, 16    f32 thickness, f32 transparency, f32 x 3 colour of each point
//
// A strand without segments is a bald root, a single point. A thickness of 0 in the header means that it is
// unknown, because hair without thickness is invisible.
//
// A file that is read and written again is the same, byte for byte. A groom from elsewhere is rounded to 32
// bits. If its look is unknown, the header has thickness 0, transparency 0 and white.
#pragma once

#include <string>
#include <string_view>

#include "hair/groom/groom.h"

namespace hair {

// Throws BadInput with a message that begins with `name`, if the file has another format, a length that its
// header contradicts, or a number that is not finite. It takes no memory for the header's numbers before the
// file's length agrees with them.
Groom parse_hair_file(std::string_view bytes, const std::string& name, Numbers numbers = Numbers::finite);

// Throws BadInput for a groom that can't be written (groom_bytes.h); a strand has 65,535 segments at most,
// unless all have the same number of them.
std::string hair_file_of(const Groom& groom);

}  // namespace hair
