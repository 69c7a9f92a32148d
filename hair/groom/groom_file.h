// Grooms from files and into files: the name's ending selects the format.
//
//   ending   bald roots   look   text
//   .hair    yes          yes    yes     (hair_file.h)
//   .ply     yes          yes            (ply_file.h)
#pragma once

#include <filesystem>
#include <string>

#include "hair/groom/groom.h"

namespace hair {

// A program without readers (the library hair_no_groom_files) throws this instead: it names another program.
struct GroomFilesElsewhere {
  std::string file;
};

// Throws BadInput for a name with another ending, a file that can't be read, and content that its format's
// reader refuses.
Groom read_groom(const std::filesystem::path& file, Numbers numbers = Numbers::finite);

// Throws BadInput for a name with another ending.
void check_groom_name(const std::filesystem::path& file);

// Writes the whole file, or nothing. Throws BadInput for a name with another
// ending, a file that can't be written, and content that its format can't hold, with the file's name.
void write_groom(const Groom& groom, const std::filesystem::path& file);

}  // namespace hair
