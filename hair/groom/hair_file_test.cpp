#include "hair/groom/hair_file.h"

#include <gtest/gtest.h>

#include <limits>

#include "hair/groom/groom_bytes.h"
#include "hair/groom/made_hair_file.h"
#include "hair/io/files/bad_input.h"
#include "solver/test_refusal.h"

namespace hair {
namespace {

using Made = MadeHairFile;

std::string complaint(const std::string& bytes) {
  return tests::refusal<BadInput>([&] { parse_hair_file(bytes, "a.hair"); });
}

TEST(HairFile, StrandsHaveTheirOwnPoints) {
  const Groom groom = parse_hair_file(Made().bytes(), "a.hair");
  ASSERT_EQ(groom.strands.size(), 2U);
  EXPECT_EQ(groom.strands[0], (Eigen::VectorXd(6) << 0, 0, 0, 1, 0, 0).finished());
  EXPECT_EQ(groom.strands[1], (Eigen::VectorXd(9) << 0, 1, 0, 0, 1, 1, 0, 1, 2).finished());
}

TEST(HairFile, AThicknessOfZeroIsNotKnown) {
  EXPECT_FALSE(parse_hair_file(Made().bytes(), "a.hair").look.thickness);
  const Groom plain{{Eigen::VectorXd::Zero(6)}};
  const GroomLook look = parse_hair_file(hair_file_of(plain), "a.hair").look;
  EXPECT_FALSE(look.thickness);
  EXPECT_EQ(look.transparency, 0);
  EXPECT_EQ(look.colour, (std::array<float, 3>{1, 1, 1}));
}

TEST(HairFile, WhatIsReadAndWrittenIsTheSameByteForByte) {
  for (std::uint32_t arrays = 2; arrays < 32; ++arrays) {
    if (!(arrays & 2)) continue;
    Made made{.arrays = arrays, .segments = 7};
    if (!(arrays & 1)) made.own.clear(), made.strands = 1, made.segments = 4;
    const std::size_t more = 5U * (((arrays & 4) ? 1 : 0) + ((arrays & 8) ? 1 : 0) + ((arrays & 16) ? 3 : 0));
    for (std::size_t k = 0; k < more; ++k) put_real(made.rest, 0.1F * static_cast<float>(k));
    made.numbers[4] = -0.0F;
    made.numbers[5] = std::numeric_limits<float>::denorm_min();
    std::string bytes = made.bytes();
    for (std::size_t at = 20; at < 40; at += 4) bytes[at + 3] = static_cast<char>(at);
    bytes.replace(40, 5, "words");
    EXPECT_EQ(hair_file_of(parse_hair_file(bytes, "a.hair")), bytes) << arrays;
  }
}

TEST(HairFile, StrandsOfOneLengthNeedNoArray) {
  Groom groom{{Eigen::VectorXd::Zero(9), Eigen::VectorXd::Ones(9)}};
  EXPECT_EQ(hair_file_of(groom).size(), 128U + 72);
  groom.strands.emplace_back(Eigen::VectorXd::Ones(6));
  EXPECT_EQ(hair_file_of(groom).size(), 128U + 6 + 96);
  EXPECT_EQ(parse_hair_file(hair_file_of(groom), "a.hair").strands, groom.strands);
  groom.strands = {Eigen::VectorXd::Zero(3 * 70000)};
  EXPECT_EQ(parse_hair_file(hair_file_of(groom), "a.hair").strands, groom.strands);
}

TEST(HairFile, WhatItCanNotHoldIsNotWritten) {
  const auto unwritten = [](const Groom& groom) {
    return tests::refusal<BadInput>([&] { hair_file_of(groom); });
  };
  const Eigen::VectorXd two = Eigen::VectorXd::Zero(6);
  EXPECT_EQ(unwritten({}), "the groom has no strands; a file has one at least");
  EXPECT_EQ(unwritten({{two, Eigen::VectorXd::Constant(6, 1e39)}}),
            "strand 1 of the groom: has a number that is not finite, or too large for 32 bits");
  EXPECT_EQ(unwritten({{two, Eigen::VectorXd::Zero(3 * 65537)}}),
            "strand 1 of the groom: has 65536 segments; in a .hair file it has at most 65535");
  EXPECT_EQ(unwritten({{two}, {.thicknesses = {1}}}),
            "the groom has 1 numbers for its points' thickness; 2 are right");
}

TEST(HairFile, ACutOrALongerFileSaysWhere) {
  const std::string whole = Made().bytes();
  EXPECT_EQ(complaint(whole.substr(0, 127)),
            "a.hair: is not a .hair file, which begins with \"HAIR\" and a header of 128 bytes");
  EXPECT_EQ(complaint(whole.substr(0, 150)),
            "a.hair: has 150 bytes, and its header says 192; it is cut off or damaged");
  EXPECT_EQ(complaint(whole + "x"),
            "a.hair: has 193 bytes, and its header says 192; it is cut off or damaged");
}

TEST(HairFile, AHeaderThatLiesIsRefusedBeforeThereIsMemoryForIt) {
  EXPECT_EQ(complaint(Made{.strands = 4000000000U}.bytes()),
            "a.hair: has 192 bytes, and its header says 8000000188; it is cut off or damaged");
  EXPECT_EQ(complaint(Made{.points = 4000000000U}.bytes()),
            "a.hair: byte 8: says that there are 4000000000 points; at most 20000000 are read");
  EXPECT_EQ(complaint(Made{.strands = 4000000000U, .arrays = 2, .own = {}}.bytes()),
            "a.hair: byte 4: says that there are 4000000000 strands and 5 points; a strand has one at least");
  const std::string damaged =
      "a.hair: byte 8: says that there are 5 points, and its strands do not have so many; it is damaged";
  EXPECT_EQ(complaint(Made{.strands = 1, .arrays = 2, .segments = 4294967295U, .own = {}}.bytes()), damaged);
  EXPECT_EQ(complaint(Made{.own = {1, 65535}}.bytes()), damaged);
  EXPECT_EQ(complaint(Made{.own = {1, 1}}.bytes()), damaged);
}

TEST(HairFile, WhatIsNoGroomIsRefused) {
  EXPECT_EQ(complaint(Made{.strands = 0, .points = 0, .own = {}, .numbers = {}}.bytes()),
            "a.hair: byte 4: says that there are no strands; a groom has one at least");
  EXPECT_EQ(complaint(Made{.arrays = 1}.bytes()),
            "a.hair: byte 12: says that there are no points; a groom is made of them");
  EXPECT_EQ(complaint(Made{.arrays = 67}.bytes()),
            "a.hair: byte 12: names arrays that a .hair file does not have (67; the sum of 1, 2, 4, 8 and 16 "
            "is right)");
}

TEST(HairFile, ALookThatIsNotFiniteIsRefused) {
  std::string bytes = Made().bytes(), number;
  put_real(number, std::numeric_limits<float>::infinity());
  EXPECT_EQ(complaint(bytes.replace(20, 4, number)),
            "a.hair: byte 20: the thickness has a number that is not finite");
}

}  // namespace
}  // namespace hair
