// Common properties of all formats of grooms that are read: a test is a property, a row is a format.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "hair/groom/groom_bytes.h"
#include "hair/groom/groom_file.h"
#include "hair/groom/hair_file.h"
#include "hair/groom/ply_file.h"
#include "hair/io/files/bad_input.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace hair {
namespace {

// Strands of two points and of three; the last number is a float of its own.
Groom written_groom() {
  return {{(Eigen::VectorXd(6) << 0, 0, 0, 1, 0, 0).finished(),
           (Eigen::VectorXd(9) << 0, 1, 0, 0, 1, 1, 0, -0.0, 0.1F).finished()}};
}

struct Format {
  const char* name;
  std::string (*write)(const Groom& groom);
  Groom (*parse)(std::string_view bytes, const std::string& name, Numbers numbers);
  const char* where;  // a number of the second strand's second point
};

const Format kFormats[] = {
    {"hair", hair_file_of, parse_hair_file, "a.hair: byte 172: strand 1, point 1: "},
    {"ply", ply_file_of, parse_ply_file, "a.ply: byte 247: vertex 3 "},
};

class GroomFormats : public testing::TestWithParam<Format> {
 protected:
  const Format format_ = GetParam();
  const std::string name_ = std::string("a.") + format_.name;
  const std::string bytes_ = format_.write(written_groom());

  std::string complaint(const std::string& bytes) const {
    return tests::refusal<BadInput>([&] { format_.parse(bytes, name_, Numbers::finite); });
  }
};

INSTANTIATE_TEST_SUITE_P(, GroomFormats, testing::ValuesIn(kFormats), [](const auto& row) {
  return std::to_string(row.index) + std::string(row.param.name).substr(0, 4);
});

TEST_P(GroomFormats, WhatIsWrittenIsReadAndWrittenAgainByteForByte) {
  const Groom again = format_.parse(bytes_, name_, Numbers::finite);
  ASSERT_EQ(again.strands, written_groom().strands);
  EXPECT_TRUE(std::signbit(again.strands[1][7]));
  EXPECT_EQ(format_.write(again), bytes_);
}

TEST_P(GroomFormats, BaldRootsStay) {
  Groom groom = written_groom();
  groom.strands.insert(groom.strands.begin() + 1, Eigen::VectorXd::Ones(3));
  EXPECT_EQ(format_.parse(format_.write(groom), name_, Numbers::finite).strands, groom.strands);
  groom.strands = {Eigen::VectorXd::Ones(3), Eigen::VectorXd::Zero(3)};
  EXPECT_EQ(format_.parse(format_.write(groom), name_, Numbers::finite).strands, groom.strands);
}

// Each point has a look of its own: in whole 255ths, and with all digits.
TEST_P(GroomFormats, ALookStays) {
  for (const float step : {1.0F, 0.3F}) {
    Groom groom = written_groom();
    for (int k = 0; k < 5; ++k) {
      const float number = step * static_cast<float>(k);
      groom.look.thicknesses.push_back(number / 7);
      groom.look.transparencies.push_back(number / 255);
      groom.look.colours.insert(groom.look.colours.end(), {number / 255, 1, 0});
    }
    const GroomLook again = format_.parse(format_.write(groom), name_, Numbers::finite).look;
    EXPECT_EQ(again.thicknesses, groom.look.thicknesses);
    EXPECT_EQ(again.transparencies, groom.look.transparencies);
    EXPECT_EQ(again.colours, groom.look.colours);
  }
}

// A PLY file can't store a common look of all points: each point has it.
TEST_P(GroomFormats, ALookOfAllPointsStays) {
  Groom groom = written_groom();
  groom.look = {.thickness = 0.1F, .transparency = 0.2F, .colour = {{0.3F, 0.4F, 0.5F}}};
  const GroomLook again = format_.parse(format_.write(groom), name_, Numbers::finite).look;
  const auto parts = parts_of(groom.look), parts_again = parts_of(again);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(parts_again[i].is_known()) << parts[i].name;
    for (std::size_t k = 0; k < parts_again[i].numbers().size(); ++k)
      EXPECT_EQ(parts_again[i].numbers()[k], parts[i].of_all[k % parts[i].size]) << parts[i].name;
  }
}

TEST_P(GroomFormats, EveryLengthButItsOwnIsRefused) {
  for (std::size_t size = 0; size < bytes_.size(); ++size)
    EXPECT_NE(complaint(bytes_.substr(0, size)), "") << size;
  EXPECT_NE(complaint(bytes_ + "1"), "");
}

TEST_P(GroomFormats, NumbersThatAreNotFiniteAreRefusedUnlessTheyAreAskedFor) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    Groom groom = written_groom();
    groom.strands[1][4] = 0.25;  // bits that no other number has
    std::string bytes = format_.write(groom), number, instead;
    put_real(number, 0.25F);
    put_real(instead, static_cast<float>(bad));
    ASSERT_NE(bytes.find(number), std::string::npos);
    bytes.replace(bytes.find(number), number.size(), instead);
    EXPECT_EQ(complaint(bytes), format_.where + std::string("has a number that is not finite"));
    EXPECT_FALSE(std::isfinite(format_.parse(bytes, name_, Numbers::any).strands[1][4]));
  }
}

// --- Real grooms from the folder HAIR_GROOMS, and names of files.

namespace fs = std::filesystem;

constexpr std::size_t kMost = 10'000'000;

class RealGrooms : public testing::Test {
 protected:
  void SetUp() override {
    if (const char* const folder = std::getenv("HAIR_GROOMS"))
      folder_ = folder;
    else
      GTEST_SKIP() << "HAIR_GROOMS does not say where real grooms are";
  }
  fs::path operator()(const std::string& name) const { return folder_ / name; }
  std::string bytes(const std::string& name) const { return read_file(folder_ / name, kMost, "a groom"); }

  fs::path folder_;
};

TEST_F(RealGrooms, HaveTheirStrandsAndPoints) {
  const Groom straight = read_groom((*this)("straight.hair"));
  ASSERT_EQ(straight.strands.size(), 10000U);
  for (const Eigen::VectorXd& x : straight.strands) ASSERT_EQ(x.size(), 48);
  EXPECT_EQ(straight.strands[0][2], static_cast<double>(59.63301F));
  EXPECT_EQ(straight.look.thickness, 0.1F);
  EXPECT_EQ(straight.look.colours.size(), 480'000U);
  EXPECT_TRUE(std::string(straight.look.info.data(), 20).starts_with("Hair model file"));
  const Groom curly = read_groom((*this)("Curly_100.ply"));
  EXPECT_EQ(curly.strands.size(), 100U);
  EXPECT_EQ(points_of(curly), 2528);
}

TEST_F(RealGrooms, AreWrittenAsTheyWereByteForByte) {
  for (const std::string name : {"straight.hair", "Bangs_100.hair"})
    EXPECT_TRUE(hair_file_of(read_groom((*this)(name))) == bytes(name)) << name;
  // The header may be worded differently.
  const auto body = [](const std::string& ply) { return ply.substr(ply.find("end_header")); };
  EXPECT_TRUE(body(ply_file_of(read_groom((*this)("Curly_100.ply")))) == body(bytes("Curly_100.ply")));
}

TEST_F(RealGrooms, TheSameGroomInTwoFormatsHasTheSamePoints) {
  const Groom hair = read_groom((*this)("Bangs_100.hair"));
  EXPECT_EQ(read_groom((*this)("Bangs_100_ascii.ply")).strands, hair.strands);
}

TEST(GroomFile, TheEndingSaysTheFormat) {
  const TemporaryFolder folder("groom");
  Groom groom{{Eigen::VectorXd::LinSpaced(6, 0, 5), Eigen::VectorXd::LinSpaced(9, 1, 9)}};
  for (const std::string name : {"a.hair", "a.ply", "A.PLY"}) {
    write_groom(groom, folder.path() / name);
    EXPECT_EQ(read_groom(folder.path() / name).strands, groom.strands) << name;
  }
  const std::string other = "a.obj: has the ending of no groom's format; .hair and .ply are right";
  EXPECT_EQ(tests::refusal<BadInput>([] { read_groom("a.obj"); }), other);
  EXPECT_EQ(tests::refusal<BadInput>([&] { write_groom(groom, "a.obj"); }), other);
  EXPECT_EQ(tests::refusal<BadInput>([] { read_groom("no-such.hair"); }),
            "no-such.hair: can't be read (No such file or directory); give the path of a .hair file");
  EXPECT_THROW(read_groom("/"), BadInput);
  groom.strands.emplace_back();
  const fs::path none = folder.path() / "none.ply";
  EXPECT_EQ(tests::refusal<BadInput>([&] { write_groom(groom, none); }),
            none.string() + ": strand 2 of the groom: has no points; one at least is right");
  EXPECT_FALSE(fs::exists(none));
}

}  // namespace
}  // namespace hair
