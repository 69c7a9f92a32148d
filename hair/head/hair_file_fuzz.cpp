// Hostile bytes as a .hair file. What is accepted can be written, and is the same when it is read again.
#include <cstdint>
#include <limits>
#include <numeric>

#include "hair/head/hair_file.h"
#include "hair/head/made_hair_file.h"
#include "hair/io/files/bad_input.h"
#include "hair/io/fuzz/fuzz.h"

namespace {

using hair::Groom, hair::MadeHairFile;

std::string written(const Groom& groom) {
  MadeHairFile file{static_cast<std::uint32_t>(groom.strands.size()), 0, 3, 0, {}, {}};
  for (const Eigen::VectorXd& x : groom.strands) {
    file.points += static_cast<std::uint32_t>(x.size() / 3);
    file.own.push_back(static_cast<std::uint16_t>(x.size() / 3 - 1));
    for (const double number : x) file.numbers.push_back(static_cast<float>(number));
  }
  return file.bytes();
}

void check(const Groom& groom) {
  fuzz::expect(!groom.strands.empty(), "a groom has strands");
  for (const Eigen::VectorXd& x : groom.strands) {
    fuzz::expect(x.size() >= 6 && x.size() % 3 == 0, "a strand has two points or more");
    fuzz::expect(x.allFinite(), "points are finite");
    if (x.size() / 3 - 1 > std::numeric_limits<std::uint16_t>::max()) return;  // can't be written
    for (Eigen::Index k = 3; k < x.size(); k += 3)
      fuzz::expect(x.segment<3>(k) != x.segment<3>(k - 3), "neighbours are at two places");
  }
  fuzz::expect(hair::parse_hair_file(written(groom), "b.hair").strands == groom.strands,
               "a groom that is written is read as it was");
}

}  // namespace

void fuzz::try_input(std::string_view bytes) {
  Groom groom;
  try {
    groom = hair::parse_hair_file(bytes, "a.hair");
  } catch (const hair::BadInput& error) {
    expect_readable(error.what());
    expect(std::string_view(error.what()).starts_with("a.hair: "), "a message begins with the file's name");
    return;
  }
  check(groom);
}

// 24 bytes of numbers for 12 of a point, and 20 for a strand, which has two points. This groom, the one that is
// read again, and between them its numbers and a text that grows to twice its size.
std::size_t fuzz::most_memory(std::size_t input) {
  return 10'000 + 10 * input;
}

std::vector<std::string> fuzz::seeds() {
  MadeHairFile all{.arrays = 31};
  all.rest = std::string(5 * 20, 'x');
  const MadeHairFile same{.strands = 1, .arrays = 2, .segments = 4, .own = {}};
  MadeHairFile many{.strands = 30, .points = 90, .arrays = 2, .segments = 2, .own = {}};
  many.numbers.resize(270);
  std::iota(many.numbers.begin(), many.numbers.end(), 0.0F);
  return {MadeHairFile().bytes(), all.bytes(), same.bytes(), many.bytes()};
}
