// STAFF ONLY. Grooms in scenes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "hair/groom/groom_file.h"
#include "hair/groom/hair_file.h"
#include "hair/groom/made_hair_file.h"
#include "hair/io/files/bad_input.h"
#include "hair/io/files/temporary_folder.h"
#include "hair/io/files/write_file.h"
#include "hair/scene/scene_run.h"
#include "hair/simulation/models.h"
#include "solver/test_refusal.h"

namespace reference_tests {
namespace {

// A folder with a scene that names a groom.
struct Folder : hair::TemporaryFolder {
  Folder() : TemporaryFolder("groom-scene") {}

  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    hair::write_file(path() / name, bytes);
    return path() / name;
  }
  std::filesystem::path scene(const std::string& groom, const std::string& more = "") const {
    return write("a.json",
                 R"({"shows": "a groom", "frames": 1, "method": "implicit_euler", "hair": [{"groom": {)" +
                     groom + "}" + more + "}]}");
  }
  std::string complaint(const std::string& groom, const std::string& more = "") const {
    const std::string said = tests::refusal<hair::BadInput>([&] { hair::read_scene(scene(groom, more)); });
    return said.substr(said.find("hair[0]"));
  }
};

// The bytes of a .hair file of one strand through the points.
std::string hair_file(const std::vector<float>& numbers) {
  const auto points = static_cast<std::uint32_t>(numbers.size() / 3);
  return hair::MadeHairFile{1, points, 2, points - 1, {}, numbers}.bytes();
}

TEST(GroomScene, IsScaledAndMovedAndRestsAsItIs) {
  const Folder folder;
  folder.write("a.hair", hair_file({0, 0, 0, 0, 0, 2, 0, 2, 2}));
  const hair::Scene scene =
      hair::read_scene(folder.scene(R"("file": "a.hair", "scale": 0.5, "move": [1, 0, 0])"));
  ASSERT_EQ(scene.hair.strands.size(), 1U);
  const hair::StrandStart& start = scene.hair.strands[0];
  EXPECT_EQ(start.state.x, (Eigen::VectorXd(9) << 1, 0, 0, 1, 0, 1, 1, 1, 1).finished());
  EXPECT_TRUE(start.strand.clamped);
  EXPECT_EQ(start.strand.root_tangent, Eigen::Vector3d(0, 0, 1));
  EXPECT_NEAR(start.rest_curvature.tail<2>().norm(), M_PI / 2, 1e-15);
}

TEST(GroomScene, IsOfRigidLinksIfItSaysSo) {
  const Folder folder;
  folder.write("a.hair", hair_file({0, 0, 0, 0, 0, 2, 0, 2, 2}));
  const hair::Scene scene = hair::read_scene(
      folder.scene(R"("file": "a.hair", "scale": 0.05, "move": [1, 0, 0])", R"(, "model": "rigid_links")"));
  EXPECT_TRUE(scene.hair.strands.empty());
  ASSERT_EQ(scene.hair.modelled.size(), 1U);
  hair::SceneRun scene_run(scene);
  EXPECT_LE((scene_run.centre_lines(scene_run.state()).x -
             (Eigen::VectorXd(9) << 1, 0, 0, 1, 0, 0.1, 1, 0.1, 0.1).finished())
                .norm(),
            1e-15);
  const auto trouble = scene_run.advance();
  EXPECT_FALSE(trouble) << *trouble;
}

TEST(GroomScene, BadGroomsAreNamedWithTheJsonPath) {
  const Folder folder;
  folder.write("cut.hair", hair_file({0, 0, 0, 1, 1, 1}).substr(0, 140));
  std::string said = folder.complaint(R"("file": "cut.hair", "scale": 1)");
  EXPECT_EQ(said.find("hair[0].groom.file: "), 0U) << said;
  EXPECT_NE(said.find("cut.hair: has 140 bytes, and its header says 152"), std::string::npos) << said;

  folder.write("nan.hair", hair_file({0, 0, 0, 1, NAN, 1}));
  said = folder.complaint(R"("file": "nan.hair", "scale": 1)");
  EXPECT_NE(said.find("nan.hair: byte 144: strand 0, point 1: has a number that is not finite"),
            std::string::npos)
      << said;

  folder.write("folded.hair", hair_file({0, 0, 0, 0, 0, 1, 0, 0, 0.5}));
  EXPECT_EQ(folder.complaint(R"("file": "folded.hair", "scale": 1)"),
            "hair[0].groom: strand 0 of the groom: bends by more than 154 degrees; no hair rests so");

  folder.write("short.hair", hair_file({0, 0, 0, 0, 0, 1, 0, 0, 1}));
  EXPECT_EQ(
      folder.complaint(R"("file": "short.hair", "scale": 1)"),
      "hair[0].groom.file: strand 0 of the groom: its point 2 is where the point before it is; a segment "
      "has a length");

  folder.write("far.hair", hair_file({0, 0, 0, 0, 0, 1e38F}));
  EXPECT_EQ(folder.complaint(R"("file": "far.hair", "scale": 1)"),
            "hair[0].groom.scale: strand 0 of the groom: is farther than 1e+06 m; give a smaller one");
}

TEST(GroomScene, BaldRootsAreLeftOutAndCounted) {
  const Folder folder;
  const hair::Groom groom{
      {Eigen::VectorXd::Zero(3), Eigen::VectorXd::LinSpaced(6, 0, 1), Eigen::VectorXd::Ones(3)}};
  const std::filesystem::path file = folder.write("a.hair", "");
  hair::write_groom(groom, file);
  const hair::Scene scene = hair::read_scene(folder.scene(R"("file": "a.hair", "scale": 1)"));
  EXPECT_EQ(scene.hair.strands.size(), 1U);
  EXPECT_EQ(scene.bald_roots, 2);
  hair::write_groom({{Eigen::VectorXd::Zero(3)}}, file);
  EXPECT_EQ(folder.complaint(R"("file": "a.hair", "scale": 1)"),
            "hair[0].groom.file: all its strands are bald roots, of a single point");
}

// A lattice of upright hairs of three points on a plane, 1 apart.
hair::Groom lattice(int side) {
  hair::Groom groom;
  for (int i = 0; i < side; ++i)
    for (int k = 0; k < side; ++k)
      groom.strands.push_back((Eigen::VectorXd(9) << i, k, 0, i, k, 1, i, k, 2).finished());
  return groom;
}

TEST(GroomScene, TakesStrandsThatAreWellSpreadWithThePointsThatItAsksFor) {
  const Folder folder;
  hair::write_groom(lattice(9), folder.write("a.hair", ""));
  const hair::Scene scene =
      hair::read_scene(folder.scene(R"("file": "a.hair", "scale": 0.01, "strands": 20, "points": 5)"));
  ASSERT_EQ(scene.hair.strands.size(), 20U);
  for (const hair::StrandStart& one : scene.hair.strands) {
    EXPECT_EQ(one.strand.count(), 5);
    EXPECT_NEAR(one.strand.rest_length.sum(), 0.02, 1e-15);
    for (const hair::StrandStart& other : scene.hair.strands)
      if (&one != &other) {
        EXPECT_GE((one.state.x.head<3>() - other.state.x.head<3>()).norm(), 0.0099);
      }
  }
}

TEST(GroomScene, GuidesOfAGroomAreDrawnAsDenseHair) {
  const Folder folder;
  hair::write_groom(lattice(9), folder.write("a.hair", ""));
  const hair::Scene scene = hair::read_scene(folder.write(
      "b.json", R"({"shows": "dense", "frames": 1, "method": "implicit_euler", "render": {}, "hair": [
    {"segments": 1, "length": 0.1, "roots": {"list": [{"position": [0, 0, 0]}]}},
    {"groom": {"file": "a.hair", "scale": 0.01, "strands": 20, "points": 5},
     "synthesis": {"strands": 500}}]})"));
  ASSERT_EQ(scene.dense.size(), 1U);
  const hair::DenseHair& dense = scene.dense[0];
  EXPECT_EQ(dense.first, 1);
  EXPECT_EQ(dense.description.points, 5);
  ASSERT_EQ(dense.description.guides.size(), 20U);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(dense.description.guides[i].position, scene.hair.strands[i + 1].state.x.head<3>());
    EXPECT_LE((dense.description.guides[i].axis - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  }
  // Children grow on the groom's scalp, also beyond the guides.
  ASSERT_EQ(dense.description.children.size(), 500U);
  for (const hair::RootFrame& child : dense.description.children) {
    EXPECT_NEAR(child.position.z(), 0, 1e-12);
    EXPECT_TRUE((child.position.head<2>().array() >= 0).all() &&
                (child.position.head<2>().array() <= 0.08).all());
  }
}

TEST(GroomScene, GuidesWithOtherNumbersOfPointsAreRefused) {
  const Folder folder;
  hair::Groom groom = lattice(2);
  groom.strands[2].conservativeResize(6);
  hair::write_groom(groom, folder.write("a.hair", ""));
  const auto said = [&](const std::string& more) {
    return folder.complaint(R"("file": "a.hair", "scale": 0.01)" + more, R"(, "synthesis": {"strands": 5})");
  };
  EXPECT_EQ(
      said(""),
      "hair[0].groom: strand 2 of the groom: has 2 points, and the first strand 3; guides have as many, so "
      "give \"points\"");
}

TEST(GroomScene, HairThatGrowsOnABustStaysWhereItIsButForItsWeight) {
  const Folder folder;
  const hair::Scene scene = hair::read_scene(folder.write("b.json", R"({"shows": "grown", "frames": 1,
    "method": "implicit_euler", "gravity": [0, 0, 0],
    "hair": [{"groom": {"style": "long-smooth", "strands": 30, "points": 16, "at": [1, 2, 3]}}],
    "obstacles": [{"bust": {"at": [1, 2, 3]}}]})"));
  ASSERT_EQ(scene.hair.strands.size(), 30U);
  for (const hair::StrandStart& start : scene.hair.strands)
    for (Eigen::Index k = 3; k < start.state.x.size(); k += 3)
      EXPECT_GT(hair::surface_at(scene.hair.obstacles[0], start.state.x.segment<3>(k)).distance, 0);
  hair::SceneRun scene_run(scene);
  const particles::State before = scene_run.state();
  EXPECT_FALSE(scene_run.advance());
  // Rounding of a metre, over a step squared and a mass: far below a micrometre.
  EXPECT_LT((scene_run.state().x - before.x).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(GroomScene, AStyleThatNeedsMorePointsSaysSo) {
  const Folder folder;
  EXPECT_EQ(folder.complaint(R"("style": "long-smooth", "strands": 3, "points": 4)"),
            "hair[0].groom: strands of 4 points; long-smooth has 8 at least, to follow its shape");
}

TEST(GroomScene, ARealGroomMovesLikeHair) {
  const char* const grooms = std::getenv("HAIR_GROOMS");
  if (!grooms) GTEST_SKIP() << "HAIR_GROOMS does not say where real grooms are";
  const Folder folder;
  const hair::Scene scene = hair::read_scene(folder.scene(
      "\"file\": \"" + std::string(grooms) + R"(/straight.hair", "scale": 0.0045, "strands": 100)"));
  ASSERT_EQ(scene.hair.strands.size(), 100U);
  EXPECT_EQ(hair::exercises_of(scene), (std::vector<std::string>{"S1", "H1", "H4"}));
  hair::SceneRun scene_run(scene);
  const auto trouble = scene_run.advance();
  EXPECT_FALSE(trouble) << *trouble;
  // In a thirtieth of a second nothing falls by more than g t^2 / 2 = 5.5 mm and some stretch.
  EXPECT_LT((scene_run.state().x - hair::SceneRun(scene).state().x).cwiseAbs().maxCoeff(), 0.01);
  EXPECT_LT(scene_run.measure(scene_run.state()).stretch, 0.05);
}

}  // namespace
}  // namespace reference_tests
