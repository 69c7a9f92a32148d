#include "hair/groom/groom_file.h"

#include <algorithm>

#include "hair/groom/groom_bytes.h"
#include "hair/groom/hair_file.h"
#include "hair/groom/ply_file.h"
#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/write_file.h"

namespace hair {

namespace {

// ".hair", also for "A.HAIR".
std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return ending;
}

// True for .hair, false for .ply.
bool is_hair_file(const std::filesystem::path& file) {
  const std::string ending = ending_of(file);
  if (ending != ".hair" && ending != ".ply")
    throw BadInput(printable(file.string(), 4096) +
                   ": has the ending of no groom's format; .hair and .ply are right");
  return ending == ".hair";
}

}  // namespace

Groom read_groom(const std::filesystem::path& file, Numbers numbers) {
  return is_hair_file(file)
             ? parse_hair_file(read_file(file, kMostGroomBytes, "a .hair file"), file.string(), numbers)
             : parse_ply_file(read_file(file, kMostGroomBytes, "a .ply file"), file.string(), numbers);
}

void check_groom_name(const std::filesystem::path& file) {
  is_hair_file(file);
}

void write_groom(const Groom& groom, const std::filesystem::path& file) {
  const bool is_hair = is_hair_file(file);
  std::string bytes;
  try {
    bytes = is_hair ? hair_file_of(groom) : ply_file_of(groom);
  } catch (const BadInput& error) {
    throw BadInput(printable(file.string(), 4096) + ": " + error.what());
  }
  write_file(file, bytes);
}

}  // namespace hair
