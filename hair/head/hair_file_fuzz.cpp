// Hostile bytes as a .hair file. What is accepted is written as it was, byte for byte.
#include <numeric>

#include "hair/head/hair_file.h"
#include "hair/head/made_hair_file.h"
#include "hair/io/files/bad_input.h"
#include "hair/io/fuzz/fuzz.h"

using hair::Groom, hair::MadeHairFile;

void fuzz::try_input(std::string_view bytes) {
  Groom groom;
  try {
    groom = hair::parse_hair_file(bytes, "a.hair");
  } catch (const hair::BadInput& error) {
    expect_readable(error.what());
    expect(std::string_view(error.what()).starts_with("a.hair: "), "a message begins with the file's name");
    return;
  }
  expect(!groom.strands.empty(), "a groom has strands");
  for (const Eigen::VectorXd& x : groom.strands) {
    expect(x.size() >= 6 && x.size() % 3 == 0, "a strand has two points or more");
    expect(x.allFinite(), "points are finite");
  }
  expect(hair::hair_file_of(groom) == bytes, "a file that is read and written is the same");
}

// 24 bytes of numbers for 12 of a point, and 20 for a strand, which has two points; its arrays, and the file
// that is written, which grows to twice its size.
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
