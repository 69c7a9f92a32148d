#include "hair/head/usda_file.h"

#include <gtest/gtest.h>

#include <regex>

#include "hair/io/files/bad_input.h"

namespace hair {
namespace {

Groom two_strands() {
  return {{(Eigen::VectorXd(6) << 0, 0, 0, 1, 0, 0).finished(),
           (Eigen::VectorXd(9) << 0, 1, 0, 0, 1, 1, 0, 1, 0.1).finished()},
          {.thickness = 0.5F, .transparency = 0.25F, .colour = {{1, 1, 1}}}};
}

// What stands between `name = [` and the next `]`, without white space.
std::string list(const std::string& text, const std::string& name) {
  const std::size_t begin = text.find(name + " = [");
  EXPECT_NE(begin, std::string::npos) << name;
  const std::size_t from = begin + name.size() + 4;
  return std::regex_replace(text.substr(from, text.find(']', from) - from), std::regex("\\s"), "");
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(UsdaFile, CurvesHaveTheGroomsPoints) {
  const std::string text = usda_file_of(two_strands(), {.unit = 0.01, .z_is_up = false});
  EXPECT_TRUE(text.starts_with("#usda 1.0\n(\n")) << text;
  EXPECT_TRUE(says(text, "metersPerUnit = 0.01\n")) << text;
  EXPECT_TRUE(says(text, "upAxis = \"Y\"\n")) << text;
  EXPECT_TRUE(says(text, "type = \"linear\"\n")) << text;
  EXPECT_EQ(list(text, "int[] curveVertexCounts"), "2,3");
  EXPECT_EQ(list(text, "point3f[] points"), "(0,0,0),(1,0,0),(0,1,0),(0,1,1),(0,1,0.1)");
  EXPECT_EQ(list(text, "float[] widths"), "0.5");
  EXPECT_EQ(list(text, "color3f[] primvars:displayColor"), "(1,1,1)");
  EXPECT_EQ(list(text, "float[] primvars:displayOpacity"), "0.75");
  EXPECT_EQ(list(text, "float3[] extent"), "(-0.25,-0.25,-0.25),(1.25,1.25,1.25)");
}

TEST(UsdaFile, ALookOfEachPointIsThatOfAVertex) {
  Groom groom = two_strands();
  groom.look.thicknesses = {1, 2, 3, 4, 5};
  groom.look.transparencies = {0, 0.25, 0.5, 0.75, 1};
  for (int k = 0; k < 15; ++k) groom.look.colours.push_back(static_cast<float>(k) / 16);
  const std::string text = usda_file_of(groom, {.cubic = true});
  EXPECT_EQ(list(text, "float[] widths"), "1,2,3,4,5");
  EXPECT_EQ(list(text, "float[] primvars:displayOpacity"), "1,0.75,0.5,0.25,0");
  EXPECT_EQ(
      list(text, "color3f[] primvars:displayColor"),
      "(0,0.0625,0.125),(0.1875,0.25,0.3125),(0.375,0.4375,0.5),(0.5625,0.625,0.6875),(0.75,0.8125,0.875)");
  EXPECT_FALSE(says(text, "constant")) << text;
  EXPECT_TRUE(says(text, "type = \"cubic\"\n")) << text;
  EXPECT_TRUE(says(text, "wrap = \"pinned\"\n")) << text;
  EXPECT_EQ(list(text, "int[] curveVertexCounts"), "2,3");
}

TEST(UsdaFile, ALookThatIsNotKnownIsNotThere) {
  Groom groom = two_strands();
  groom.look = {};
  const std::string text = usda_file_of(groom);
  for (const char* const part : {"widths", "displayColor", "displayOpacity"})
    EXPECT_FALSE(says(text, part)) << text;
  EXPECT_EQ(list(text, "float3[] extent"), "(0,0,0),(1,1,1)");
}

TEST(UsdaFile, ABaldRootIsNoCurve) {
  EXPECT_THROW(usda_file_of({{Eigen::VectorXd::Zero(3)}}), BadInput);
}

}  // namespace
}  // namespace hair
