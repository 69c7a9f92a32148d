// Hostile bytes as a groom, in each format. An accepted groom can be written: as .hair with the same bytes,
// as PLY with points rounded to 32 bits.
#include <numeric>

#include "hair/groom/groom_bytes.h"
#include "hair/groom/hair_file.h"
#include "hair/groom/made_hair_file.h"
#include "hair/groom/ply_file.h"
#include "hair/io/files/bad_input.h"
#include "hair/io/fuzz/fuzz.h"

namespace {

using hair::Groom;

// The groom that `parse` makes of the bytes; empty if it refuses them with a readable message.
Groom groom_of(std::string_view bytes, auto parse) {
  Groom groom;
  try {
    groom = parse(bytes, "a.file", hair::Numbers::finite);
  } catch (const hair::BadInput& error) {
    fuzz::expect_readable(error.what());
    fuzz::expect(std::string_view(error.what()).starts_with("a.file: "),
                 "a message begins with the file's name");
    return {};
  }
  fuzz::expect(!groom.strands.empty(), "a groom has strands");
  for (const Eigen::VectorXd& x : groom.strands) {
    fuzz::expect(x.size() >= 3 && x.size() % 3 == 0, "a strand has a point or more");
    fuzz::expect(x.allFinite(), "points are finite");
  }
  return groom;
}

void expect_written_as_it_was(std::string_view bytes, auto parse, auto write) {
  const Groom groom = groom_of(bytes, parse);
  if (!groom.strands.empty())
    fuzz::expect(write(groom) == bytes, "a file that is read and written is the same");
}

void expect_written_as_ply(std::string_view bytes) {
  const Groom groom = groom_of(bytes, hair::parse_ply_file);
  if (groom.strands.empty()) return;
  const Groom again = hair::parse_ply_file(hair::ply_file_of(groom), "b.ply", hair::Numbers::finite);
  fuzz::expect(again.look.colours == groom.look.colours, "colours stay");
  fuzz::expect(again.look.transparencies == groom.look.transparencies, "transparencies stay");
  fuzz::expect(again.look.thicknesses == groom.look.thicknesses, "thicknesses stay");
  fuzz::expect(again.strands.size() == groom.strands.size(), "strands stay");
  for (std::size_t i = 0; i < groom.strands.size(); ++i)
    fuzz::expect(again.strands[i] == groom.strands[i].cast<float>().cast<double>(),
                 "points stay, as 32 bits");
}

}  // namespace

void fuzz::try_input(std::string_view bytes) {
  expect_written_as_it_was(bytes, hair::parse_hair_file, hair::hair_file_of);
  expect_written_as_ply(bytes);
}

// As text a point takes six bytes; in memory 24 in a list and 24 in its strand, for this groom and the one
// that is read again from 12 bytes and two edges. A .hair file takes a fifth of it.
std::size_t fuzz::most_memory(std::size_t input) {
  return 20'000 + 100 * input;
}

std::vector<std::string> fuzz::seeds() {
  std::vector<std::string> all;

  hair::MadeHairFile whole{.arrays = 31};
  whole.rest = std::string(5 * 20, 'x');
  const hair::MadeHairFile same{.strands = 1, .arrays = 2, .segments = 4, .own = {}};
  hair::MadeHairFile many{.strands = 30, .points = 90, .arrays = 2, .segments = 2, .own = {}};
  many.numbers.resize(270);
  std::iota(many.numbers.begin(), many.numbers.end(), 0.0F);
  for (const hair::MadeHairFile& one : {hair::MadeHairFile(), whole, same, many}) all.push_back(one.bytes());

  const auto line = [](int points) -> Eigen::VectorXd {
    return Eigen::VectorXd::LinSpaced(3 * points, 0, 1.5 * points);
  };
  Groom groom{{line(2), line(3), line(5)}};
  const std::string plain = hair::ply_file_of(groom);
  all.push_back(plain);
  groom.look.colours.assign(30, 0.2F);
  all.push_back(hair::ply_file_of(groom));
  groom.look.thicknesses.assign(10, 0.1F);
  groom.look.transparencies.assign(10, 0.3F);
  all.push_back(hair::ply_file_of(groom));
  std::string big = plain;
  all.push_back(big.replace(big.find("little"), 6, "big"));
  all.emplace_back(
      "ply\nformat ascii 1.0\nelement thing 1\nproperty list uchar int of\nelement vertex 2\nproperty double "
      "z\n"
      "property float y\nproperty int8 x\nelement strand 1\nproperty uint nsegs\nend_header\n2 5 6\n1 2 3\n4 "
      "5 6\n"
      "1\n");
  return all;
}
