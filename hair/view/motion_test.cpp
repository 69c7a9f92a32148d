// STAFF ONLY. A motion's file: its precision, its size, and its handling of objects that fly away or
// disappear.
#include "hair/view/motion.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "hair/view/test_motion.h"
#include "hair/view/view_page.h"

namespace hair {
namespace {

using Json = nlohmann::json;

Vector3d shown(const Json& motion, int frame, int point) {
  return point_of(motion, bytes_of_base64(motion["data"]), static_cast<std::size_t>(frame),
                  static_cast<std::size_t>(point));
}

// Strands that swing in different directions.
Drawing swing(int strands, int points, double time) {
  Drawing drawing;
  for (int s = 0; s < strands; ++s) {
    drawing.strands.sizes.push_back(points);
    for (int i = 0; i < points; ++i)
      drawing.strands.points.emplace_back(0.01 * s + 0.02 * i * std::sin(time + s), 0.003 * s,
                                          -0.02 * i * std::cos(time + s));
  }
  return drawing;
}

MotionStory story(int frames) {
  MotionStory story{.name = "swing", .shows = "</script><!--<script>", .ended = "finished", .blow_up = ""};
  for (int k = 0; k < frames; ++k) story.times.push_back(k / 30.0);
  story.series = {{"energy", "J", std::vector<double>(static_cast<std::size_t>(frames), 1.0)}};
  return story;
}

TEST(MotionFile, KeepsPositionsToATenThousandthOfTheSceneInALittleSpace) {
  constexpr int kFrames = 90, kStrands = 40, kPoints = 11;
  MotionFrames frames(kFrames);
  for (int k = 0; k < kFrames; ++k) frames.add(swing(kStrands, kPoints, k / 30.0));
  const std::string text = frames.json(story(kFrames));
  EXPECT_LE(text.size(), 350'000U);
  const Json motion = Json::parse(text);
  ASSERT_EQ(motion["strands"], std::vector<int>(kStrands, kPoints));
  const Vector3d low(motion["low"][0], motion["low"][1], motion["low"][2]),
      high(motion["high"][0], motion["high"][1], motion["high"][2]);
  // Half a step, and the rounding of floats.
  const double bound = (high - low).maxCoeff() * (0.5 / 65535 + 1e-6);
  ASSERT_LT(std::sqrt(3) * bound, 1e-4 * (high - low).norm());
  for (const int k : {0, 17, 89}) {
    const Drawing drawing = swing(kStrands, kPoints, k / 30.0);
    for (int i = 0; i < kStrands * kPoints; i += 37)
      EXPECT_LE((shown(motion, k, i) - drawing.strands.points[static_cast<std::size_t>(i)])
                    .lpNorm<Eigen::Infinity>(),
                bound)
          << k << " " << i;
  }
}

TEST(MotionFile, AParticleThatFliesAwayCostsTheOthersNoDigits) {
  MotionFrames frames(2);
  Drawing drawing = swing(2, 5, 0);
  frames.add(drawing);
  const Vector3d before = drawing.strands.points[3];
  drawing.strands.points[7] = Vector3d(1e12, 0, 0);
  drawing.strands.points[3].setConstant(std::numeric_limits<double>::quiet_NaN());
  frames.add(drawing);
  const Json motion = Json::parse(frames.json(story(2)));
  const double size = (Vector3d(motion["high"][0], motion["high"][1], motion["high"][2]) -
                       Vector3d(motion["low"][0], motion["low"][1], motion["low"][2]))
                          .norm();
  EXPECT_LT(size, 4);  // ten times the first frame's, which is below 0.2 m
  EXPECT_LT((shown(motion, 1, 3) - before).norm(), 1e-4 * size) << "it stays where it was";
}

TEST(MotionFile, LeavesStrandsOutOfLargeMotionsAndSaysHowMany) {
  MotionFrames frames(10, 10 * 20 * 5);  // twenty strands of five points
  for (int k = 0; k < 10; ++k) frames.add(swing(61, 5, k));
  const Json motion = Json::parse(frames.json(story(10)));
  EXPECT_EQ(motion["strands_in_all"], 61);
  EXPECT_LE(motion["strands"].size(), 20U);
  EXPECT_GE(motion["strands"].size(), 15U);
}

TEST(MotionFile, StrandsKeepTheirPlacesWhereOthersGoOutOfView) {
  Drawing drawing = swing(3, 4, 0), later = swing(3, 4, 1);
  drawing.strands.ids = {7, 8, 9};
  later.strands.ids = {7, 9};
  later.strands.sizes.erase(later.strands.sizes.begin() + 1);
  later.strands.points.erase(later.strands.points.begin() + 4, later.strands.points.begin() + 8);
  MotionFrames frames(2);
  frames.add(drawing);
  frames.add(later);
  const Json motion = Json::parse(frames.json(story(2)));
  EXPECT_LT((shown(motion, 1, 4) - drawing.strands.points[4]).norm(), 1e-5);
  EXPECT_LT((shown(motion, 1, 8) - later.strands.points[4]).norm(), 1e-5);
}

TEST(MotionFile, HoldsBallsLimbsClothAndSolidsBehindTheStrands) {
  Drawing drawing = swing(1, 3, 0);
  drawing.tubes.push_back({Vector3d(0, 0, 0), Vector3d(0.1, 0, 0), 0.001, Colour(1, 0, 0)});
  drawing.balls.push_back({Vector3d(0.05, 0, 0), 0.01, Colour(0, 1, 0)});
  drawing.obstacles.push_back({.shape = Sphere{Vector3d(0, 0, -0.1), 0.05}});
  drawing.obstacles.push_back({.shape = Plane{Vector3d(0, 0, -0.2), Vector3d(0, 0, 1)}});
  drawing.sheets.push_back(
      {2,
       2,
       {Vector3d(0, 0, 0), Vector3d(0.1, 0, 0), Vector3d(0, 0.1, 0), Vector3d(0.1, 0.1, 0)},
       Colour(0, 0, 1)});
  MotionFrames frames(1);
  frames.add(drawing);
  const Json motion = Json::parse(frames.json(story(1)));
  EXPECT_EQ(motion["points"], 3 + 2 * 3 + 4);
  EXPECT_EQ(motion["first_rod"], 3);
  EXPECT_EQ(motion["rods"].size(), 3U);
  EXPECT_EQ(motion["sheets"][0]["first"], 9);
  EXPECT_LT((shown(motion, 0, 4) - Vector3d(0.1, 0, 0)).norm(), 1e-5);
  EXPECT_LT((shown(motion, 0, 12) - Vector3d(0.1, 0.1, 0)).norm(), 1e-5);
  EXPECT_EQ(motion["planes"][0]["points"], std::vector<double>({0, 0, -0.2}));
}

TEST(ViewPage, NothingInARunEndsTheScriptThatHoldsIt) {
  MotionFrames frames(1);
  frames.add(swing(1, 2, 0));
  const std::string page = view_page({{"<b>\"", frames.json(story(1))}});
  const std::size_t begin = page.find("id=\"motion\""), end = page.find("</script>", begin);
  const std::size_t data = page.find('>', begin) + 1;
  EXPECT_EQ(page.substr(data, end - data).find('<'), std::string::npos);
  EXPECT_EQ(Json::parse(page.substr(data, end - data))["shows"], "</script><!--<script>");
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_LE(page.size(), 100'000U) << "all of the page but the motion";
}

}  // namespace
}  // namespace hair
