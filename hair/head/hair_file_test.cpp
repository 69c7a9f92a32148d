#include "hair/head/hair_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>

#include "hair/head/made_hair_file.h"
#include "hair/io/files/bad_input.h"

namespace hair {
namespace {

using Made = MadeHairFile;

std::string complaint(const std::string& bytes) {
  try {
    parse_hair_file(bytes, "a.hair");
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

TEST(HairFile, StrandsHaveTheirOwnPoints) {
  const Groom groom = parse_hair_file(Made().bytes(), "a.hair");
  ASSERT_EQ(groom.strands.size(), 2U);
  EXPECT_EQ(groom.strands[0], (Eigen::VectorXd(6) << 0, 0, 0, 1, 0, 0).finished());
  EXPECT_EQ(groom.strands[1], (Eigen::VectorXd(9) << 0, 1, 0, 0, 1, 1, 0, 1, 2).finished());
}

TEST(HairFile, WithoutTheArrayOfSegmentsAllStrandsHaveThoseOfTheHeader) {
  Made made{.strands = 1, .points = 5, .arrays = 2, .segments = 4, .own = {}};
  EXPECT_EQ(parse_hair_file(made.bytes(), "a.hair").strands[0].size(), 15);
}

TEST(HairFile, ThicknessTransparencyAndColoursArePassedOver) {
  Made made{.arrays = 31};
  made.rest = std::string(5 * 20, 'x');
  EXPECT_EQ(parse_hair_file(made.bytes(), "a.hair").strands[1][8], 2);
}

TEST(HairFile, EveryLengthButItsOwnIsRefused) {
  const std::string whole = Made().bytes();
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(complaint(whole.substr(0, size)), "") << size;
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
            "a.hair: has 4000000000 points; at most 10000000 are read");
  EXPECT_EQ(complaint(Made{.strands = 4000000000U, .arrays = 2, .own = {}}.bytes()),
            "a.hair: has 4000000000 strands and 5 points; a strand has two at least");
  EXPECT_EQ(complaint(Made{.strands = 1, .arrays = 2, .segments = 4294967295U, .own = {}}.bytes()),
            "a.hair: its strands do not have the 5 points that its header says; it is damaged");
  EXPECT_EQ(complaint(Made{.own = {1, 65535}}.bytes()),
            "a.hair: its strands do not have the 5 points that its header says; it is damaged");
  EXPECT_EQ(complaint(Made{.own = {1, 1}}.bytes()),
            "a.hair: its strands do not have the 5 points that its header says; it is damaged");
}

TEST(HairFile, WhatIsNoGroomIsRefused) {
  EXPECT_EQ(complaint(Made{.own = {4, 0}}.bytes()),
            "a.hair: strand 1 is a single point; a strand has two at least");
  EXPECT_EQ(complaint(Made{.strands = 0, .points = 0, .own = {}, .numbers = {}}.bytes()),
            "a.hair: has no strands; a groom has one at least");
  EXPECT_EQ(complaint(Made{.arrays = 1}.bytes()), "a.hair: has no points; a groom is made of them");
  EXPECT_EQ(complaint(Made{.arrays = 67}.bytes()),
            "a.hair: has arrays that a .hair file does not (67; the sum of 1, 2, 4, 8 and 16 is right)");
  Made made;
  made.numbers[10] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(complaint(made.bytes()), "a.hair: strand 1, point 1: has a number that is not finite");
  made.numbers[10] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(complaint(made.bytes()), "a.hair: strand 1, point 1: has a number that is not finite");
  made = {};
  made.numbers[3] = 0;
  EXPECT_EQ(complaint(made.bytes()),
            "a.hair: strand 0, point 1: is where the point before it is; a segment has a length");
}

TEST(HairFile, APathThatIsNoFileIsNamed) {
  try {
    read_hair_file("no-such.hair");
    ADD_FAILURE();
  } catch (const BadInput& error) {
    EXPECT_STREQ(error.what(),
                 "no-such.hair: can't be read (No such file or directory); give the path of a .hair file");
  }
  EXPECT_THROW(read_hair_file("/"), BadInput);
}

TEST(HairFile, RealGroomsAreReadAndTheirHalvesAreNot) {
  const char* const folder = std::getenv("HAIR_GROOMS");
  if (!folder) GTEST_SKIP() << "HAIR_GROOMS does not say where real grooms are";
  const Groom straight = read_hair_file(std::filesystem::path(folder) / "straight.hair");
  ASSERT_EQ(straight.strands.size(), 10000U);
  for (const Eigen::VectorXd& x : straight.strands) ASSERT_EQ(x.size(), 48);
  EXPECT_FLOAT_EQ(static_cast<float>(straight.strands[0][2]), 59.63301F);

  const Groom bangs = read_hair_file(std::filesystem::path(folder) / "Bangs_100.hair");
  ASSERT_EQ(bangs.strands.size(), 100U);
  Eigen::Index points = 0;
  for (const Eigen::VectorXd& x : bangs.strands) points += x.size() / 3;
  EXPECT_EQ(points, 1165);

  std::ifstream in(std::filesystem::path(folder) / "Bangs_100.hair", std::ios::binary);
  std::string bytes(7000, '\0');
  in.read(bytes.data(), 7000);
  EXPECT_EQ(complaint(bytes), "a.hair: has 7000 bytes, and its header says 14308; it is cut off or damaged");
}

}  // namespace
}  // namespace hair
