// STAFF ONLY. Dense hair of a scene as it is drawn, with the reference's H10.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "hair/render/scene_drawing.h"

namespace hair {
namespace {

constexpr int kGuides = 30, kChildren = 200;

// A tuft that a motion turns, in which each strand has four points, and a strand of three points that nobody makes dense. The camera
// sees a part of the tuft, from -y; z is up.
Scene tuft(bool shadows) {
  return parse_scene(R"({"shows": "a tuft", "frames": 10,
    "motions": [{"name": "hand", "keys": [{"time": 0}, {"time": 1, "axis": [0, 1, 0], "degrees": 90}]}],
    "hair": [
      {"segments": 3, "length": 0.09, "moves_with": "hand",
       "roots": {"disc": {"centre": [0, 0, 0], "normal": [0, 0, 1], "radius": 0.02, "count": 30}},
       "synthesis": {"strands": 200, "mode": "blend"}},
      {"segments": 2, "length": 0.1, "roots": {"list": [{"position": [0, 0, 0.1]}]}}],
    "render": {"view": [0, -1, 0], "look_at": [0.012, 0, 0.02], "zoom": 20, "shadows": )" +
                         std::string(shadows ? "true" : "false") + "}}",
                     "tuft.json");
}

const std::vector<int> kSizes = [] {
  std::vector<int> sizes(kGuides, 4);
  sizes.push_back(3);
  return sizes;
}();

// Guides straight along the scalp's normal, which has turned about y by `angle`.
particles::State tuft_state(const Scene& scene, double angle) {
  const Eigen::AngleAxisd turn(angle, Vector3d::UnitY());
  constexpr int kNumbers = 3 * (4 * kGuides + 3);
  particles::State state{Eigen::VectorXd(kNumbers), Eigen::VectorXd::Zero(kNumbers)};
  for (int guide = 0; guide < kGuides; ++guide)
    for (int i = 0; i < 4; ++i)
      state.x.segment<3>(3 * (4 * guide + i)) =
          turn * (scene.dense[0].description.guides[guide].position + Vector3d(0, 0, 0.03 * i));
  state.x.tail<9>() << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  return state;
}

TEST(DenseDrawing, HasStrandsInThePlaceOfGuidesAndTheOthersAsTheyAre) {
  Scene scene = tuft(false);
  scene.look->zoom = 0.1;
  const SceneDrawing drawing(scene, kSizes);
  const StrandsDrawing strands = drawing.at(tuft_state(scene, 0), {}, 0).strands;
  ASSERT_EQ(strands.sizes.size(), kChildren + 1U);
  EXPECT_EQ(strands.sizes.back(), 3);
  EXPECT_EQ(strands.points.back(), Vector3d(7, 8, 9));
  for (int child = 0; child < kChildren; ++child)
    for (int i = 0; i < 4; ++i) {
      const Vector3d expected =
          scene.dense[0].description.children[child].position + Vector3d(0, 0, 0.03 * i);
      EXPECT_LE((strands.points[static_cast<std::size_t>(4 * child + i)] - expected).norm(), 1e-14)
          << "between straight guides all strands are straight; child " << child;
    }
  EXPECT_EQ(drawing.synthesised().children, kChildren);
}

TEST(DenseDrawing, TurnsWithItsMotion) {
  Scene scene = tuft(false);
  scene.look->zoom = 0.1;
  const SceneDrawing drawing(scene, kSizes);
  const double angle = std::numbers::pi / 2;
  const StrandsDrawing strands = drawing.at(tuft_state(scene, angle), {}, 1).strands;
  for (int child = 0; child < kChildren; ++child) {
    const Vector3d root =
        Eigen::AngleAxisd(angle, Vector3d::UnitY()) * scene.dense[0].description.children[child].position;
    EXPECT_LE((strands.points[static_cast<std::size_t>(4 * child)] - root).norm(), 1e-14)
        << "child " << child;
    EXPECT_LE((strands.points[static_cast<std::size_t>(4 * child + 3)] - root - Vector3d(0.09, 0, 0)).norm(),
              1e-14);
  }
}

// What is left out on the picture's left and below throws no shadow into it from there; light comes from the left and
// from above, so with shadows those sides are no limits.
TEST(DenseDrawing, LeavesOutWhatNobodySees) {
  const Scene plain = tuft(false), shaded = tuft(true);
  const SceneDrawing without(plain, kSizes), with(shaded, kSizes);
  const particles::State state = tuft_state(plain, 0);
  const std::size_t drawn = without.at(state, {}, 0).strands.sizes.size();
  with.at(state, {}, 0);
  const SynthesisCounts counts = without.synthesised(), shadows = with.synthesised();
  EXPECT_GT(counts.children_out_of_view, 20);
  EXPECT_GT(counts.children, 20);
  EXPECT_GT(counts.guides_idle, 0);
  EXPECT_EQ(drawn, static_cast<std::size_t>(counts.children) + 1);
  EXPECT_LT(shadows.children_out_of_view, counts.children_out_of_view);
}

TEST(DenseDrawing, SaysInWhichSceneItIs) {
  const std::vector<std::string> calls = exercises_of(tuft(false));
  EXPECT_EQ(std::count(calls.begin(), calls.end(), "H10"), 1);
  Scene scene = tuft(false);
  scene.dense.clear();
  const std::vector<std::string> others = exercises_of(scene);
  EXPECT_EQ(std::count(others.begin(), others.end(), "H10"), 0);
}

}  // namespace
}  // namespace hair
