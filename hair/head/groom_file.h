// Grooms from files and into files: the name's ending says which format.
//
//   .hair    read and written (hair_file.h)
//   .data    read and written (data_file.h); the only one with bald roots
//   .ply     read and written (ply_file.h)
//   .usda    written (usda_file.h)
#pragma once

#include <filesystem>
#include <string>

#include "hair/head/groom.h"
#include "hair/head/usda_file.h"

namespace hair {

// Thrown instead by a program that has no readers (the library hair_no_groom_files): it names another program.
struct GroomFilesElsewhere {
  std::string file;
};

// Throws BadInput for a name with another ending, a file that can't be read, and what its format's reader
// refuses.
Groom read_groom(const std::filesystem::path& file, Numbers numbers = Numbers::finite);

struct GroomFileSettings {
  bool ascii = false;  // of .ply
  UsdaSettings usda = {};
};

// Whether the format that the name's ending says has bald roots. Throws BadInput for a name with an ending
// that no writer has.
bool can_write_bald_roots(const std::filesystem::path& file);

// The whole file appears, or nothing. Throws BadInput for a name with another ending, a file that can't be
// written, and what its format can't hold, with the file's name.
void write_groom(const Groom& groom, const std::filesystem::path& file,
                 const GroomFileSettings& settings = {});

}  // namespace hair
