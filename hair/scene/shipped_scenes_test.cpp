// STAFF ONLY. The scenes that ship, with the reference: a few frames of each.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "hair/scene/scene_run.h"

namespace reference_tests {
namespace {

constexpr int kMostStrands = 100;

std::vector<std::filesystem::path> shipped() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(HAIR_SCENES))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

TEST(ShippedScenes, AreThoseThatAUserIsPromised) {
  std::set<std::string> names;
  for (const auto& file : shipped()) names.insert(file.stem().string());
  for (const char* name :
       {"strand-swing", "long-straight", "short-curly", "wavy", "strand-over-sphere", "ponytail", "pendulum",
        "bead-on-wire", "cloth-patch", "stiff", "extreme", "wind", "head-of-hair"})
    EXPECT_TRUE(names.count(name)) << name;
}

// `hairlab scenes` reads outlines.
TEST(ShippedScenes, AnOutlineShowsAndCallsWhatTheSceneDoesWithFewStrands) {
  for (const auto& file : shipped()) {
    const hair::Scene scene = hair::read_scene(file), outline = hair::read_outline(file);
    EXPECT_EQ(outline.shows, scene.shows) << file;
    EXPECT_EQ(hair::exercises_of(outline), hair::exercises_of(scene)) << file;
    for (const hair::DenseHair& dense : outline.dense)
      EXPECT_LE(dense.description.children.size(), 4u) << file;
  }
  // Four strands of each group: of three lines, a disc and a grown groom.
  EXPECT_EQ(hair::read_outline(HAIR_SCENES "/wind.json").hair.strands.size(), 12u);
  EXPECT_EQ(hair::read_outline(HAIR_SCENES "/ponytail.json").hair.strands.size(), 4u);
  EXPECT_EQ(hair::read_outline(HAIR_SCENES "/head-of-hair.json").hair.strands.size(), 4u);
}

TEST(ShippedScenes, APonytailHas200Strands) {
  EXPECT_EQ(hair::read_scene(HAIR_SCENES "/ponytail.json").hair.strands.size(), 500U);
}

TEST(ShippedScenes, PlayAndMove) {
  for (const auto& file : shipped()) {
    hair::Scene scene = hair::read_scene(file);
    // Hundreds of hairs move like the first ones; linked ones are one system.
    if (scene.hair.strands.size() > kMostStrands && !scene.hair.mesh) {
      scene.hair.strands.resize(kMostStrands);
      for (hair::Rider& rider : scene.riders)
        std::erase_if(rider.strands, [](int strand) { return strand >= kMostStrands; });
    }
    hair::SceneRun scene_run(scene);
    const particles::State start = scene_run.state();
    // Scenes with more particles run fewer frames.
    const int frames = std::clamp(static_cast<int>(3000 / start.x.size()), 1, 4);
    for (int k = 0; k < frames; ++k) {
      const auto trouble = scene_run.advance();
      ASSERT_FALSE(trouble) << scene.name << ": " << *trouble;
    }
    const particles::State end = scene_run.state();
    EXPECT_TRUE(end.x.allFinite() && end.v.allFinite()) << scene.name;
    const hair::FrameMeasures measures = scene_run.measure(end);
    EXPECT_TRUE(std::isfinite(measures.energy()) && std::isfinite(measures.stretch)) << scene.name;
    EXPECT_GT((end.x - start.x).cwiseAbs().maxCoeff(), 1e-5) << scene.name;
    EXPECT_EQ(scene_run.frame(), frames);
    EXPECT_TRUE(scene.look) << scene.name;
    EXPECT_GE(scene.frames, 30) << scene.name;
  }
}

}  // namespace
}  // namespace reference_tests
