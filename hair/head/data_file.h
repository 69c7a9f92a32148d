// Grooms as .data files. Source: L. Hu, C. Ma, L. Luo and H. Li, "Single-View Hair Modeling Using a Hairstyle
// Database" (SIGGRAPH 2015): the files of the USC-HairSalon database. All little-endian:
//
//   i32         strands
//   i32 m       for each strand: its points; 1 is a bald root
//   f32 x 3     m times: the points, from the root
//
// A file that is read and written is the same, byte for byte. A groom from elsewhere loses its look, and what
// 32 bits can't hold of its points. So the points of a .hair file survive a .data file, and come back the
// same.
#pragma once

#include <string>
#include <string_view>

#include "hair/head/groom.h"

namespace hair {

// Throws BadInput with a message that begins with `name`, if the file does not have the strands that it says
// or bytes after them, or a number is not finite. No memory is taken for what it says before its length
// agrees.
Groom parse_data_file(std::string_view bytes, const std::string& name, Numbers numbers = Numbers::finite);

// Throws BadInput for a groom that can't be written (groom_bytes.h).
std::string data_file_of(const Groom& groom);

}  // namespace hair
