// Grooms from files and into files: the name's ending says which format.
//
//   ending   read   written   bald roots   look   text
//   .hair    yes    yes       yes          yes    yes     (hair_file.h)
//   .data    yes    yes       yes                         (data_file.h)
//   .ply     yes    yes       yes          yes            (ply_file.h)
//   .usda           yes                    yes            (usda_file.h)
#pragma once

#include <filesystem>
#include <string>
#include <vector>

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

// What else of the groom's file a file with this name can't hold: "text"; and what of a look is not known that the format
// has: "thickness". Both throw as can_write_bald_roots does.
std::vector<std::string> lost_in(const std::filesystem::path& file, const Groom& groom);
std::vector<std::string> unknown_in(const std::filesystem::path& file, const Groom& groom);

// The whole file appears, or nothing. Throws BadInput for a name with another ending, a file that can't be
// written, and what its format can't hold, with the file's name.
void write_groom(const Groom& groom, const std::filesystem::path& file,
                 const GroomFileSettings& settings = {});

}  // namespace hair
