// STAFF ONLY. Dense hair of a scene as it is drawn, with the reference's H10.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>

#include "hair/scene/scene_run.h"
#include "hair/scene_drawing/idle_guides.h"
#include "hair/scene_drawing/scene_drawing.h"

namespace hair {
namespace {

constexpr int kGuides = 30, kChildren = 200;

// A tuft that a motion turns, in which each strand has four points, and a simulated strand of three points.
// The camera sees a part of the tuft, from -y; z is up.
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

// Without shadows, the sides of the picture limit the drawn hair. Light comes from the left and from above,
// so with shadows those two sides are no limits.
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

// A cap of hair that starts straight down, through the ball on which it grows.
double deepest_in_ball(const char* hair, bool moved) {
  const Scene scene = parse_scene(R"({"shows": "hair in a ball", "frames": 1,
    "hair": [{"segments": 8, "length": 0.2, "start": {"direction": [0.1, 0, -1]},
      "roots": {"cap": {"centre": [0, 0, 0], "radius": 0.1, "count": 40}},
      "synthesis": {"strands": 500, "fly_aways": 0.1, "clump": 20}}],
    "obstacles": [{"sphere": {"centre": [0, 0, 0], "radius": 0.1}}],
    "render": {"hair": ")" + std::string(hair) +
                                      R"("}})",
                                  "ball.json");
  const SceneRun scene_run(scene);
  const SceneDrawing drawing(scene, scene_run.strands());
  const StrandsDrawing strands =
      drawing.at(scene_run.centre_lines(scene_run.state()), scene_run.obstacles(), 0).strands;
  EXPECT_EQ(drawing.moved_out() > 0, moved);
  double deepest = 0;
  for (const Vector3d& point : strands.points) deepest = std::max(deepest, 0.1 - point.norm());
  return deepest;
}

TEST(DenseDrawing, KeepsFineHairOutOfObstaclesAndLeavesRibbonsAsH10MakesThem) {
  EXPECT_LE(deepest_in_ball("fine", true), StrandClearance::kTolerance);
  EXPECT_GT(deepest_in_ball("ribbons", false), 0.05);
}

// Hair that does not move on its own follows its head, and each strand keeps its number, whatever else the
// camera sees.
TEST(DenseDrawing, StillHairGoesWithItsHead) {
  const Scene scene = parse_scene(R"({"shows": "a tail", "frames": 1,
    "motions": [{"name": "walk", "keys": [{"time": 0}, {"time": 1, "position": [0, 1, 0], "axis": [0, 0, 1], "degrees": 90}]}],
    "hair": [{"segments": 2, "length": 0.1, "moves_with": "walk", "roots": {"list": [{"position": [0, 0.1, 0]}]}}],
    "still_hair": [{"groom": {"style": "ponytail", "strands": 20, "points": 9, "head": "ellipsoid"}, "moves_with": "walk"}],
    "render": {"hair": "fine"}})",
                                  "tail.json");
  const SceneRun scene_run(scene);
  const SceneDrawing drawing(scene, scene_run.strands());
  const particles::State state = scene_run.centre_lines(scene_run.state());
  const StrandsDrawing before = drawing.at(state, {}, 0).strands, after = drawing.at(state, {}, 1).strands;
  ASSERT_EQ(before.sizes.size(), 21U);
  EXPECT_EQ(before.ids, after.ids);
  EXPECT_NE(before.ids[0], before.ids[1]);
  for (std::size_t i = 3; i < before.points.size(); ++i) {
    const Vector3d& from = before.points[i];
    EXPECT_LE((after.points[i] - Vector3d(-from.y(), from.x() + 1, from.z())).norm(), 1e-14);
  }
}

// A row of tufts' guides on a disc of 40 cm that moves aside and turns a little; the camera sees a part of
// it.
Scene wide_tuft(const std::string& hair = "", const std::string& more = "", int guides = 200,
                double length = 0.04) {
  return parse_scene(
      R"({"shows": "a wide tuft", "frames": 8, "frames_per_second": 20, "method": "implicit_euler", "drag": 1e-4,
    "motions": [{"name": "hand", "keys": [{"time": 0},
      {"time": 0.3, "position": [0.05, 0, 0], "axis": [0, 1, 0], "degrees": 20}]}],
    "hair": [{"segments": 4, "moves_with": "hand", "start": {"direction": [1, 0, -1]}, "length": )" +
          std::to_string(length) + R"(,
      "roots": {"disc": {"centre": [0, 0, 0], "normal": [0, 0, -1], "radius": 0.4, "count": )" +
          std::to_string(guides) + R"(}},
      "synthesis": {"strands": 2000, "spread": 1.5, "jitter": 0.2, "length": 0.1)" +
          hair + R"(}}],
    "render": {"view": [0, -0.1, 1], "look_at": [0.25, 0, 0], "zoom": 7, "shadows": false})" +
          more + "}",
      "wide.json");
}

void expect_no_picture_shows_idle_guides(const Scene& scene) {
  SceneRun all(scene), some(scene);
  const SceneDrawing drawing(scene, all.strands()), other(scene, some.strands());
  const std::vector<int> idle = idle_guides(scene, drawing);
  const std::size_t guides = scene.hair.strands.size();
  EXPECT_GT(idle.size(), guides / 10);
  EXPECT_LT(idle.size(), guides * 9 / 10);
  some.leave_out(idle);
  for (int k = 0; k <= scene.frames; ++k) {
    const auto drawn = [](const SceneDrawing& by, const SceneRun& scene_run) {
      return by.at(scene_run.centre_lines(scene_run.state()), scene_run.obstacles(), scene_run.time())
          .strands;
    };
    const StrandsDrawing one = drawn(drawing, all), two = drawn(other, some);
    ASSERT_EQ(one.sizes, two.sizes) << "frame " << k;
    ASSERT_EQ(one.points, two.points) << "frame " << k;
    ASSERT_FALSE(all.advance() || some.advance());
  }
  const auto count = static_cast<long>(guides);
  EXPECT_EQ(some.work().strand_steps,
            all.work().strand_steps / count * (count - static_cast<long>(idle.size())));
}

// The pictures are the same, in any frame, when the idle guides stand still.
TEST(IdleGuides, NoPictureShowsThem) {
  for (const char* const mode : {R"(, "mode": "interpolate")", R"(, "mode": "extrapolate")", ""}) {
    SCOPED_TRACE(mode);
    expect_no_picture_shows_idle_guides(wide_tuft(mode));
  }
}

// Short hair in clumps whose middles are far apart: its tips are drawn into the picture from several lengths
// away.
TEST(IdleGuides, AreNotThoseWhoseStrandsGatherOrFlyIntoThePicture) {
  for (const char* const disorder :
       {R"(, "clump": 150, "gathered": 0.9)",
        R"(, "mode": "interpolate", "clump": 150, "gathered": 0.9, "fly_aways": 0.2)"}) {
    SCOPED_TRACE(disorder);
    expect_no_picture_shows_idle_guides(wide_tuft(disorder, "", 600, 0.01));
  }
}

TEST(IdleGuides, AreNoneThatMoveOthersNorHairThatIsDrawnAsItIs) {
  const Scene linked = wide_tuft("", R"(, "links": {"stiffness": 1e-4})");
  EXPECT_TRUE(idle_guides(linked, SceneDrawing(linked, {})).empty());
  SceneRun scene_run(linked);
  scene_run.leave_out({});
  EXPECT_THROW(scene_run.leave_out(std::vector<int>{0}), std::invalid_argument);
  Scene plain = wide_tuft();
  plain.dense.clear();
  EXPECT_TRUE(idle_guides(plain, SceneDrawing(plain, {})).empty());
}

TEST(IdleGuides, AreThoseThatNoStrandIsMadeOf) {
  Scene scene = wide_tuft();
  scene.look->zoom = 0.5;
  EXPECT_TRUE(idle_guides(scene, SceneDrawing(scene, {})).empty());
  scene.dense[0].description.children.resize(1);
  EXPECT_GE(idle_guides(scene, SceneDrawing(scene, {})).size(), 197U);
}

// Rows of one, one and three guides: each is linked to the one before, in its row or in the row before.
Scene linked_guides(const std::string& last_row, const std::string& look) {
  const auto row = [](const std::string& roots, const std::string& more) {
    return R"({"segments": 2, "length": 0.1, "roots": {"list": [)" + roots + "]}" + more + "}";
  };
  return parse_scene(
      R"({"shows": "links", "frames": 1, "method": "implicit_euler", "hair": [)" +
          row(R"({"position": [0, 0, 0]})", "") + ", " + row(R"({"position": [0.01, 0, 0]})", "") + ", " +
          row(R"({"position": [0.02, 0, 0]}, {"position": [0.03, 0, 0]}, {"position": [0.02, 0.01, 0]})",
              last_row) +
          R"(], "links": {"stiffness": 1e-3, "neighbours": "both"}, "render": {)" + look + "}}",
      "links.json");
}

Drawing draw_start(const Scene& scene, const MeshRecord* mesh) {
  const SceneRun scene_run(scene);
  return SceneDrawing(scene, scene_run.strands())
      .at(scene_run.centre_lines(scene_run.state()), scene_run.obstacles(), 0, mesh);
}

TEST(LinkDrawing, LinksThatHoldAreTubesIfTheLookAsksForThem) {
  const Scene scene = linked_guides("", R"("links": true)");
  const std::vector<StaticLink>& links = scene.hair.mesh->links;
  const Drawing whole = draw_start(scene, nullptr);
  ASSERT_EQ(whole.tubes.size(), links.size());
  EXPECT_EQ(whole.tubes[0].a, whole.strands.points.at(static_cast<std::size_t>(links[0].a)));
  EXPECT_EQ(whole.tubes[0].b, whole.strands.points.at(static_cast<std::size_t>(links[0].b)));

  const MeshRecord broken{{{3, 0}}, 0};
  const Drawing torn = draw_start(scene, &broken);
  ASSERT_EQ(torn.tubes.size(), links.size() - 1);
  EXPECT_EQ(torn.tubes[0].a, whole.tubes[1].a) << "the first broke in step 3";

  EXPECT_TRUE(draw_start(linked_guides("", ""), nullptr).tubes.empty());
}

TEST(LinkDrawing, NoLinkIsDrawnToGuidesWhoseDenseHairIsDrawn) {
  const Scene scene = linked_guides(R"(, "synthesis": {"strands": 5})", R"("links": true)");
  const Drawing drawing = draw_start(scene, nullptr);
  ASSERT_FALSE(drawing.tubes.empty());
  EXPECT_LT(drawing.tubes.size(), scene.hair.mesh->links.size());
  for (const Tube& tube : drawing.tubes)
    EXPECT_LT(std::max(tube.a.x(), tube.b.x()), 0.015) << "the last row begins at 0.02";
}

}  // namespace
}  // namespace hair
