// Grooms as PLY files, the way kenshi84/hairutil writes them; text or binary:
//
//   vertex   x, y, z; also red, green, blue as u8
//   strand   nsegs: its segments; nsegs + 1 vertices follow those of the strand before
//   edge     vertex1, vertex2: the segments once more, for programs that know no strands; not read
//
// Other elements and properties are passed over. Points and colours that are read from floats and u8 are
// written as they were. A groom from elsewhere loses its bald roots, thickness and transparency, its text, and what
// 32 bits of a point and 8 bits of a colour can't hold.
#pragma once

#include <string>
#include <string_view>

#include "hair/head/groom.h"

namespace hair {

// Throws BadInput with a message that begins with `name`, if the file is no PLY file, or has no strands (a
// mesh has none), not as much as its header says, bytes after that, a strand of fewer than two points, or a
// number that is not finite. No memory is taken for what the header says before the file's length agrees.
Groom parse_ply_file(std::string_view bytes, const std::string& name, Numbers numbers = Numbers::finite);

// Binary, little-endian, unless it is to be text. Throws BadInput for a groom that can't be written
// (groom_bytes.h); a strand has two points at least.
std::string ply_file_of(const Groom& groom, bool ascii = false);

}  // namespace hair
