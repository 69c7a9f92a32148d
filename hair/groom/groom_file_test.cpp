// Real grooms from the folder HAIR_GROOMS, and names of files.
#include "hair/groom/groom_file.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "hair/groom/hair_file.h"
#include "hair/groom/ply_file.h"
#include "hair/io/files/bad_input.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace hair {
namespace {

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
