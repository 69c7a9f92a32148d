// Grooms from files and into files: the name's ending selects the format.
//
//   ending   bald roots   look   text
//   .hair    yes          yes    yes     (hair_file.h)
//   .ply     yes          yes            (ply_file.h)
#pragma once

#include <filesystem>
#include <string>
#include <vector>

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

// Names the parts of the groom's file that a file with this name can't hold, such as "text", and the parts of
// a look that are not known, such as "thickness". Both throw as check_groom_name does.
std::vector<std::string> lost_in(const std::filesystem::path& file, const Groom& groom);
std::vector<std::string> unknown_in(const std::filesystem::path& file, const Groom& groom);

// Writes the whole file, or nothing. `ascii` makes a .ply file text. Throws BadInput for a name with another
// ending, a file that can't be written, and content that its format can't hold, with the file's name.
void write_groom(const Groom& groom, const std::filesystem::path& file, bool ascii = false);

}  // namespace hair
