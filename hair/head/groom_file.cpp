#include "hair/head/groom_file.h"

#include <algorithm>
#include <array>
#include <string_view>

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

struct Format {
  std::string_view ending;
  bool bald_roots, look, text;
};
constexpr std::array<Format, 4> kWritten = {{{".hair", true, true, true},
                                             {".data", true, false, false},
                                             {".ply", true, true, false},
                                             {".usda", false, true, false}}};

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

const Format& written_format(const std::filesystem::path& file) {
  const auto* const found = std::find_if(kWritten.begin(), kWritten.end(),
                                         [&](const Format& one) { return one.ending == ending_of(file); });
  if (found == kWritten.end()) refuse_ending(file, "written; .hair, .data, .ply and .usda are");
  return *found;
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
  return written_format(file).bald_roots;
}

std::vector<std::string> lost_in(const std::filesystem::path& file, const Groom& groom) {
  const Format& format = written_format(file);
  std::vector<std::string> lost = groom.not_read;
  for (const LookPart& part : parts_of(groom.look)) {
    const bool is_opaque = part.name == std::string_view("transparency") &&
                           std::all_of(part.numbers().begin(), part.numbers().end(),
                                       [](float transparency) { return transparency == 0; });
    if (!format.look && part.is_known() && !is_opaque) lost.emplace_back(part.name);
  }
  if (!format.text && groom.look.info[0] != '\0') lost.emplace_back("text");
  if (std::any_of(groom.strands.begin(), groom.strands.end(),
                  [](const Eigen::VectorXd& x) { return x != x.cast<float>().cast<double>(); }))
    lost.emplace_back("digits of points that 32 bits don't hold");
  return lost;
}

std::vector<std::string> unknown_in(const std::filesystem::path& file, const Groom& groom) {
  const Format& format = written_format(file);
  std::vector<std::string> unknown;
  constexpr std::array header = {" (the header says 0)", " (the header says 0)", " (the header says white)"};
  const auto parts = parts_of(groom.look);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (format.look && !parts[i].is_known())
      unknown.push_back(parts[i].name + std::string(format.ending == ".hair" ? header[i] : ""));
  return unknown;
}

void write_groom(const Groom& groom, const std::filesystem::path& file, const GroomFileSettings& settings) {
  const std::string ending = ending_of(file);
  written_format(file);
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
