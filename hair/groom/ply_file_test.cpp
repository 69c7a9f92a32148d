#include "hair/groom/ply_file.h"

#include <gtest/gtest.h>

#include <regex>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_comma_locale.h"
#include "solver/test_refusal.h"

namespace hair {
namespace {

// Two strands, as text.
struct MadePly {
  std::string format = "ascii 1.0";
  std::string vertices = "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n";
  std::string strands = "element strand 2\nproperty ushort nsegs\n";
  std::string body = "0 0 0\n1 0 0\n0 1 0\n0 1 1\n0 1 2.5\n1\n2\n";

  std::string text() const {
    return "ply\nformat " + format + "\ncomment by hand\n" + vertices + strands + "end_header\n" + body;
  }
};

std::string ply_complaint(const std::string& bytes) {
  return tests::refusal<BadInput>([&] { parse_ply_file(bytes, "a.ply"); });
}

TEST(PlyFile, StrandsTakeTheirVerticesInTurn) {
  const Groom groom = parse_ply_file(MadePly().text(), "a.ply");
  ASSERT_EQ(groom.strands.size(), 2U);
  EXPECT_EQ(groom.strands[0], (Eigen::VectorXd(6) << 0, 0, 0, 1, 0, 0).finished());
  EXPECT_EQ(groom.strands[1], (Eigen::VectorXd(9) << 0, 1, 0, 0, 1, 1, 0, 1, 2.5).finished());
}

TEST(PlyFile, OtherElementsAndPropertiesArePassedOver) {
  MadePly made;
  made.vertices =
      "element thing 2\nproperty list uchar int of\nproperty char c\n"
      "element vertex 2\nproperty double quality\nproperty float32 z\nproperty float y\nproperty float x\n";
  made.strands = "element strand 1\nproperty uint8 nsegs\nproperty float length\n";
  made.body = "3 7 8 9 -5\r\n0 6\r\n0.5 3 2 1\r\n0.5 6 5 4\r\n1 2.5";
  const Groom groom = parse_ply_file(made.text(), "a.ply");
  ASSERT_EQ(groom.strands.size(), 1U);
  EXPECT_EQ(groom.strands[0], (Eigen::VectorXd(6) << 1, 2, 3, 4, 5, 6).finished());
}

// hairutil writes u8, and other programs write other types. Each row: the properties, a vertex, and its
// colour, transparency and thickness.
TEST(PlyFile, ALookOfEachVertexIsRead) {
  struct Row {
    std::string properties, vertex;
    std::vector<float> colours, transparencies, thicknesses;
  };
  const std::string rgb = "property T red\nproperty T green\nproperty T blue\n";
  const auto of_type = [&](const std::string& type) {
    return std::regex_replace(rgb, std::regex("T"), type);
  };
  const Row rows[] = {
      {of_type("uchar") + "property uchar alpha\nproperty float thickness\n",
       "255 51 0 102 0.25",
       {1, 0.2F, 0},
       {0.4F},
       {0.25F}},
      {of_type("float"), ".5 0.1 2", {0.5F, 0.1F, 2}, {}, {}},
      {of_type("double") + "property double alpha\n", ".5 0.25 2 1", {0.5F, 0.25F, 2}, {1}, {}},
      {of_type("ushort"), "65535 13107 0", {1, 0.2F, 0}, {}, {}},
      {"property uchar thickness\nproperty list uchar float alpha\n", "3 1 0.5", {}, {}, {3}},
      {of_type("int"), "1 2 3", {}, {}, {}},
      {"property uchar red\nproperty float nx\n", "1 2", {}, {}, {}}};
  for (const Row& row : rows) {
    MadePly made;
    made.vertices =
        "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n" + row.properties;
    made.strands = "element strand 1\nproperty ushort nsegs\n";
    made.body = "1 2 3 " + row.vertex + "\n0\n";
    const Groom groom = parse_ply_file(made.text(), "a.ply");
    EXPECT_EQ(groom.look.colours, row.colours) << made.text();
    EXPECT_EQ(groom.look.transparencies, row.transparencies) << made.text();
    EXPECT_EQ(groom.look.thicknesses, row.thicknesses) << made.text();
  }
}

TEST(PlyFile, IsReadInBothOrders) {
  Groom groom = parse_ply_file(MadePly().text(), "a.ply");
  groom.strands[1][8] = static_cast<double>(0.1F);
  for (int k = 0; k < 15; ++k) groom.look.colours.push_back(static_cast<float>(17 * k) / 255);
  const std::string bytes = ply_file_of(groom);
  const Groom again = parse_ply_file(bytes, "a.ply");
  EXPECT_EQ(again.strands, groom.strands);
  EXPECT_EQ(again.look.colours, groom.look.colours);
  EXPECT_EQ(ply_file_of(again), bytes);
  MadePly made{.format = "binary_big_endian 1.0"};
  made.vertices = "element vertex 2\nproperty float x\nproperty short y\nproperty char z\n";
  made.strands = "element strand 1\nproperty uint nsegs\n";
  made.body = std::string("\x3f\x80\0\0\xff\xfe\xfd", 7) + std::string("\x40\0\0\0\1\0\7", 7) +
              std::string("\0\0\0\1", 4);
  EXPECT_EQ(parse_ply_file(made.text(), "a.ply").strands[0],
            (Eigen::VectorXd(6) << 1, -2, -3, 2, 256, 7).finished());
}

TEST(PlyFile, TextHasADecimalPointWhateverTheLocale) {
  const TemporaryFolder folder("locale");
  const Groom groom = parse_ply_file(MadePly().text(), "a.ply");
  const solver::CommaLocale comma(folder.path().string());
  if (!comma.is_everywhere()) GTEST_SKIP() << "the package locales is missing";
  EXPECT_EQ(parse_ply_file(MadePly().text(), "a.ply").strands, groom.strands);
}

TEST(PlyFile, ACutOrALongerFileSaysWhere) {
  const std::string text = MadePly().text();
  EXPECT_EQ(ply_complaint(text.substr(0, text.size() - 2)),
            "a.ply: line 17: the file ends here; it is cut off");
  EXPECT_EQ(ply_complaint(text + "\n 3"),
            "a.ply: line 18: there is more after the last element; a PLY file ends there");
  EXPECT_EQ(ply_complaint(text + " \r\n"), "");
}

TEST(PlyFile, CountsThatLieAreRefusedBeforeThereIsMemoryForThem) {
  MadePly made;
  made.strands = "element strand 4000000000\nproperty ushort nsegs\n";
  EXPECT_EQ(
      ply_complaint(made.text()),
      "a.ply: its header says that there are 4000000000 of \"strand\"; the 36 bytes after it are too few, "
      "and the file is cut off or damaged");
  made.strands = "element strand 99999999999999999999\nproperty ushort nsegs\n";
  EXPECT_EQ(ply_complaint(made.text()),
            "a.ply: line 8: the element \"strand\" has the count \"99999999999999999999\"; a whole number is "
            "right");
  made = {};
  made.vertices += "element nothing 18446744073709551615\n";
  EXPECT_EQ(ply_complaint(made.text()), "a.ply: the element \"nothing\" has no properties; leave it out");
  made = {};
  made.body = "0 0 0\n1 0 0\n0 1 0\n0 1 1\n0 1 2.5\n1\n3\n";
  EXPECT_EQ(ply_complaint(made.text()), "a.ply: has 5 vertices, and its strands have 6; it is damaged");
  made.body = "0 0 0\n1 0 0\n0 1 0\n0 1 1\n0 1 2.5\n1\n4e9\n";
  EXPECT_NE(ply_complaint(made.text()), "");
}

TEST(PlyFile, WhatIsNoGroomIsRefused) {
  EXPECT_EQ(ply_complaint("HAIR"), "a.ply: is not a PLY file, which begins with a line \"ply\"");
  EXPECT_EQ(
      ply_complaint(MadePly{.format = "ascii 2.0"}.text()),
      "a.ply: line 2: has the format \"ascii\" \"2.0\"; ascii, binary_little_endian and binary_big_endian "
      "1.0 are read");
  const std::string whole = MadePly().strands;
  const struct {
    std::string strands, second, segments, complaint;  // the second vertex, and what comes after the last one
  } rows[] = {
      {"element face 1\nproperty list uchar int vertex_indices\n", "1 0 0", "3 0 1 2",
       "does not have one element \"vertex\" and one \"strand\": it is no groom, but a mesh"},
      {"element strand 2\nproperty short nsegs\n", "1 0 0", "3\n-1",
       "line 17: strand 1 has a number of segments that is not 0, 1, 2, ..."},
      {whole, "1 0 zero", "1\n2", "line 12: \"zero\" is no number that \"z\" can be"},
      {whole, "1 0", "1\n2\n  ", "line 12: ends before \"z\""},
      {whole, "1 0 0 0", "1\n2", "line 12: has more numbers than the 3 properties of \"vertex\""},
      {whole, "1 0 1e39", "1\n2", "line 12: vertex 1 has a number that is not finite"},
      {whole, "1 0 0", "1.5\n2", "line 16: \"1.5\" is no number that \"nsegs\" can be"},
      {whole, "1 0 0", "65536\n2", "line 16: \"65536\" is no number that \"nsegs\" can be"},
  };
  for (const auto& [strands, second, segments, complaint] : rows) {
    const std::string body = "0 0 0\n" + second + "\n0 1 0\n0 1 1\n0 1 2.5\n" + segments + "\n";
    EXPECT_EQ(ply_complaint(MadePly{.strands = strands, .body = body}.text()), "a.ply: " + complaint);
  }
}

}  // namespace
}  // namespace hair
