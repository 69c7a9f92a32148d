// Grooms as PLY files, the way kenshi84/hairutil writes them; text is read, too:
//
//   vertex   x, y, z; also red, green, blue; alpha; thickness, in the unit of x
//   strand   nsegs: its segments, 0 for a bald root; nsegs + 1 vertices follow those of the strand before
//   edge     vertex1, vertex2: the segments once more, for programs that know no strands; not read
//
// Colours and alpha are whole numbers, u8 or u16, whose largest value is 1, or floats. As in hairutil, alpha
// is the transparency of .hair files: 0 is opaque. Other elements and properties are passed over. A groom is
// written with colours and alpha as u8 if these hold them, else as floats. Its text is lost, and its points
// are rounded to 32 bits.
#pragma once

#include <string>
#include <string_view>

#include "hair/groom/groom.h"

namespace hair {

// Throws BadInput with a message that begins with `name`, if the file is no PLY file, or has no strands (a
// mesh has none), less than its header says, bytes after that, or a number that is not finite. It takes no
// memory for the header's numbers before the file's length agrees with them.
Groom parse_ply_file(std::string_view bytes, const std::string& name, Numbers numbers = Numbers::finite);

// Binary, little-endian. Throws BadInput for a groom that can't be written (groom_bytes.h).
std::string ply_file_of(const Groom& groom);

}  // namespace hair
