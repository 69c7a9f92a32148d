#include "hair/head/groom_file.h"

#include <algorithm>

#include "hair/head/data_file.h"
#include "hair/head/groom_bytes.h"
#include "hair/head/hair_file.h"
#include "hair/head/ply_file.h"
#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/write_file.h"

namespace hair {

namespace {

// ".hair", also of "A.HAIR".
std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return ending;
}

[[noreturn]] void refuse_ending(const std::filesystem::path& file, const std::string& what) {
  throw BadInput(printable(file.string(), 4096) + ": has the ending of no format that is " + what);
}

}  // namespace

Groom read_groom(const std::filesystem::path& file, Numbers numbers) {
  const std::string ending = ending_of(file), name = file.string();
  if (ending == ".hair")
    return parse_hair_file(read_file(file, kMostGroomBytes, "a .hair file"), name, numbers);
  if (ending == ".data")
    return parse_data_file(read_file(file, kMostGroomBytes, "a .data file"), name, numbers);
  if (ending == ".ply") return parse_ply_file(read_file(file, kMostGroomBytes, "a .ply file"), name, numbers);
  refuse_ending(file, "read; .hair, .data and .ply are");
}

bool can_write_bald_roots(const std::filesystem::path& file) {
  const std::string ending = ending_of(file);
  if (ending != ".hair" && ending != ".data" && ending != ".ply" && ending != ".usda")
    refuse_ending(file, "written; .hair, .data, .ply and .usda are");
  return ending == ".data";
}

void write_groom(const Groom& groom, const std::filesystem::path& file, const GroomFileSettings& settings) {
  const std::string ending = ending_of(file);
  can_write_bald_roots(file);
  std::string bytes;
  try {
    bytes = ending == ".hair"   ? hair_file_of(groom)
            : ending == ".data" ? data_file_of(groom)
            : ending == ".ply"  ? ply_file_of(groom, settings.ascii)
                                : usda_file_of(groom, settings.usda);
  } catch (const BadInput& error) {
    throw BadInput(printable(file.string(), 4096) + ": " + error.what());
  }
  write_file(file, bytes);
}

}  // namespace hair
