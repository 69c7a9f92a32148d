// For a program that reads no grooms' files.
#include "hair/groom/groom_file.h"
#include "hair/io/files/printable.h"

namespace hair {

Groom read_groom(const std::filesystem::path& file, Numbers) {
  throw GroomFilesElsewhere{printable(file.string(), 4096)};
}

}  // namespace hair
