#include "hair/render/opengl/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "hair/render/light.h"
#include "hair/render/test_drawing.h"
#include "solver/test_refusal.h"

namespace hair {
namespace {

constexpr int kWidth = 320, kHeight = 180;
constexpr double kAspect = static_cast<double>(kWidth) / kHeight;
const RenderSettings kSmall{.width = kWidth, .height = kHeight};

// One metre from the origin, on the y axis: x is to the right, z up.
const Camera kFront{.eye = Vector3d(0, -1, 0), .target = Vector3d::Zero(), .up = Vector3d(0, 0, 1)};
const double kTangent = std::tan(kFront.field_of_view / 2);
const double kPixel = 2 * kTangent / kHeight;  // m, at the origin

double linear(std::uint8_t encoded) {
  const double c = encoded / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double brightness(const Image& image, int x, int y) {
  const std::uint8_t* const p = image.at(x, y);
  return linear(p[0]) + linear(p[1]) + linear(p[2]);
}

// The part of each pixel that black objects cover: 0 to 1.
struct Coverage {
  Image with, without;
  double at(int x, int y) const { return 1 - brightness(with, x, y) / brightness(without, x, y); }
};

Coverage coverage_of(const Drawing& drawing, const Camera& camera = kFront) {
  Renderer renderer(kSmall);
  return {renderer.draw(drawing, camera), renderer.draw({}, camera)};
}

Drawing strand(const std::vector<Vector3d>& points, double width) {
  Drawing drawing;
  drawing.strands = {{static_cast<int>(points.size())}, points, width, Colour::Zero(), Colour::Zero()};
  return drawing;
}

TEST(Renderer, DrawsTheSameBytesAgain) {
  const TestScene scene = test_scene(kAspect);
  Renderer renderer(kSmall);
  const Image first = renderer.draw(scene.drawing, scene.camera);
  EXPECT_TRUE(renderer.draw(scene.drawing, scene.camera) == first) << "at once";
  Drawing few = strand({}, 0.01);
  few.strands.sizes = {2, 2, 2};
  for (const double x : {-0.1, 0.0, 0.1}) {
    for (const double z : {0.1, -0.1}) few.strands.points.emplace_back(x, 0, z);
  }
  EXPECT_TRUE(renderer.draw(few, kFront) == Renderer(kSmall).draw(few, kFront)) << "after a larger one";
  renderer.draw({}, kFront);
  EXPECT_TRUE(renderer.draw(scene.drawing, scene.camera) == first) << "after other drawings";
  EXPECT_TRUE(Renderer(kSmall).draw(scene.drawing, scene.camera) == first) << "by a fresh renderer";
}

TEST(Renderer, TwoRenderersTakeTurns) {
  const TestScene scene = test_scene(kAspect);
  Renderer one(kSmall), other({.width = 64, .height = 64});
  const Image first = one.draw(scene.drawing, scene.camera);
  other.draw(scene.drawing, scene.camera);
  EXPECT_TRUE(one.draw(scene.drawing, scene.camera) == first);
}

// All coordinates are halved or doubled exactly, so OpenGL gets the same numbers.
TEST(Renderer, AMillimetreAndAKilometreLookLikeAMetre) {
  const TestScene metre = test_scene(kAspect);
  Renderer renderer(kSmall);
  const Image expected = renderer.draw(metre.drawing, metre.camera);
  for (const double scale : {1.0 / 1024, 1024.0}) {
    const TestScene scaled = test_scene(kAspect, scale);
    EXPECT_TRUE(renderer.draw(scaled.drawing, scaled.camera) == expected) << "scale " << scale;
  }
}

// A ball's outline is the cone of tangents from the eye: at the angle to its centre, plus and minus
// asin(radius / distance).
TEST(Renderer, ABallIsWhereTheCameraSays) {
  for (const double x : {0.0, 0.2, -0.25}) {
    const double radius = 0.1, angle = std::atan2(x, 1.0), half = std::asin(radius / std::hypot(x, 1.0));
    Drawing drawing;
    drawing.balls.push_back({Vector3d(x, 0, 0), radius, Colour::Zero()});
    const Coverage covered = coverage_of(drawing);
    int left = kWidth, right = -1;
    for (int column = 0; column < kWidth; ++column) {
      if (covered.at(column, kHeight / 2) < 0.3) continue;
      left = std::min(left, column);
      right = column;
    }
    const auto column_of = [](double tangent) { return kWidth / 2.0 + tangent / kTangent * kHeight / 2; };
    // A pixel is a pixel wide, and its filter extends half a pixel farther; a polygon's corners are within a
    // twentieth.
    EXPECT_NEAR(left, column_of(std::tan(angle - half)), 1.1) << "x " << x;
    EXPECT_NEAR(right + 1, column_of(std::tan(angle + half)), 1.1) << "x " << x;
  }
}

// Black strands at a slant, so that no highlight is visible on them. An edge is off by half a sample at most,
// which is a quarter of a pixel; the ends by a sample. Eight bits of colour are off by 1/510, and the dark
// pixel's neighbours add 1 %. Over the last fifth the width falls to nothing.
TEST(Renderer, AStrandCoversItsWidthTimesItsLength) {
  const Vector3d from(20 * kPixel, 0, -60 * kPixel), to(-10 * kPixel, 0, 60 * kPixel);
  const double length = (to - from).norm() / kPixel;
  for (const double width : {4.0, 10.0, 30.0}) {
    const Coverage covered = coverage_of(strand({from, to}, width * kPixel));
    double area = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) area += covered.at(x, y);
    }
    EXPECT_NEAR(area, 0.9 * width * length, 2 * 0.25 * length + width + 0.01 * width * length)
        << width << " pixels wide";
  }
}

TEST(Renderer, ThinHairDoesNotBreakUp) {
  const Vector3d from(-20 * kPixel, 0, -60 * kPixel), to(10 * kPixel, 0, 60 * kPixel);
  const Coverage covered = coverage_of(strand({from, to}, 1e-12));
  for (int y = kHeight / 2 - 58; y < kHeight / 2 + 58; ++y) {
    double sum = 0;
    for (int x = 0; x < kWidth; ++x) sum += covered.at(x, y);
    // One sample of each of the four rows around a pixel's middle is covered; it is half a pixel wide.
    EXPECT_NEAR(sum, 0.5, 0.2) << "row " << y;
  }
}

TEST(Renderer, WhatIsNearerHidesWhatIsFarther) {
  const Colour red(0.6F, 0, 0), blue(0, 0, 0.6F);
  for (const bool red_in_front : {true, false}) {
    Drawing drawing;
    drawing.balls.push_back({Vector3d(0, red_in_front ? -0.2 : 0.2, 0), 0.1, red});
    drawing.balls.push_back({Vector3d(0, red_in_front ? 0.2 : -0.2, 0), 0.1, blue});
    const Image image = Renderer(kSmall).draw(drawing, kFront);
    const std::uint8_t* const p = image.at(kWidth / 2, kHeight / 2);
    EXPECT_EQ(p[0] > p[2], red_in_front);
  }
  for (const bool hair_in_front : {true, false}) {
    const double y = hair_in_front ? -0.2 : 0.2;
    Drawing drawing = strand({Vector3d(0, y, -0.1), Vector3d(0, y, 0.1)}, 0.02);
    drawing.balls.push_back({Vector3d(0, 0, 0), 0.1, red});
    const Image image = Renderer(kSmall).draw(drawing, kFront);
    EXPECT_EQ(image.at(kWidth / 2, kHeight / 2)[0] < 60, hair_in_front);
  }
}

TEST(Renderer, HairThrowsShadowsWhereTheLightMeetsItAndNowhereElse) {
  // A curtain of strands above the ground, seen from in front and above.
  Drawing drawing;
  drawing.strands.width = 4e-3;
  for (int i = 0; i < 50; ++i) {
    drawing.strands.sizes.push_back(2);
    drawing.strands.points.emplace_back(-0.05 + 0.002 * i, 0, 0.10);
    drawing.strands.points.emplace_back(-0.05 + 0.002 * i, 0, 0.15);
  }
  drawing.obstacles.push_back({Plane{Vector3d::Zero(), Vector3d(0, 0, 1)}});
  const Camera camera{.eye = Vector3d(0, -0.8, 0.6), .target = Vector3d::Zero(), .up = Vector3d(0, 0, 1)};
  RenderSettings bright = kSmall;
  bright.shadows = false;
  const Image with = Renderer(kSmall).draw(drawing, camera), without = Renderer(bright).draw(drawing, camera);

  const Vector3d back = camera.eye.normalized(), right(1, 0, 0), up = back.cross(right);
  const Vector3d light = kKeyLight[0] * right + kKeyLight[1] * up + kKeyLight[2] * back.cast<double>();
  const auto pixel_of = [&](const Vector3d& at) {
    const Vector3d to = at - camera.eye;
    const double depth = -to.dot(back);
    return Eigen::Vector2d(kWidth / 2.0 + to.dot(right) / (depth * kTangent) * kHeight / 2,
                           kHeight / 2.0 - to.dot(up) / (depth * kTangent) * kHeight / 2);
  };
  Eigen::AlignedBox2d shade, hair;
  for (const double x : {-0.05, 0.05}) {
    for (const double z : {0.10, 0.15}) {
      const Vector3d at(x, 0, z);
      hair.extend(pixel_of(at));
      shade.extend(pixel_of(at - at[2] / light[2] * light));
    }
  }
  ASSERT_TRUE(hair.intersection(shade).isEmpty()) << "the test needs them apart";
  const int x = static_cast<int>(shade.center()[0]), y = static_cast<int>(shade.center()[1]);
  EXPECT_LT(brightness(with, x, y), 0.8 * brightness(without, x, y));
  // Two pixels beyond the shade, for the picture's filter and a texel of the map.
  for (int py = 0; py < kHeight; ++py) {
    for (int px = 0; px < kWidth; ++px) {
      const Eigen::Vector2d middle(px + 0.5, py + 0.5);
      if (hair.exteriorDistance(middle) <= 3 || shade.exteriorDistance(middle) <= 3) continue;
      ASSERT_EQ(brightness(with, px, py), brightness(without, px, py)) << px << ", " << py;
    }
  }
}

TEST(Renderer, NothingIsAPictureToo) {
  Renderer renderer(kSmall);
  const Image empty = renderer.draw({}, kFront);
  EXPECT_EQ(empty.pixels.size(), 3U * kWidth * kHeight);
  EXPECT_TRUE(renderer.draw(strand({Vector3d(0, 0, 0)}, 0.01), kFront) == empty) << "a strand of one point";
  EXPECT_TRUE(renderer.draw(strand(std::vector<Vector3d>(5, Vector3d(0, 0, 0)), 0.01), kFront) == empty)
      << "a strand whose points are all in one place";
}

// A tip that flew away draws its strand's last piece across the picture, and changes nothing else, at any
// distance.
TEST(Renderer, WhatIsAsFarAsNumbersGoDoesNoHarm) {
  TestScene scene = test_scene(kAspect);
  Renderer renderer(kSmall);
  const Image before = renderer.draw(scene.drawing, scene.camera);
  const auto flown = [&](double far) {
    scene.drawing.strands.points.back() = Vector3d(far, far, -far);
    return renderer.draw(scene.drawing, scene.camera);
  };
  const Image after = flown(1e9);
  int other = 0;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    other += std::equal(after.at(i, 0), after.at(i, 0) + 3, before.at(i, 0)) ? 0 : 1;
  }
  // At most a line through the picture, as wide as its filter, and its shadow.
  EXPECT_GT(other, 0);
  EXPECT_LT(other, 2 * 4 * (kWidth + kHeight));
  for (const double far : {1e50, 1e200, std::numeric_limits<double>::max()}) {
    EXPECT_TRUE(flown(far) == after) << far;
  }
}

std::string refusal(const std::function<void()>& act) {
  return tests::refusal<std::invalid_argument>([&] { act(); });
}

TEST(Renderer, RefusesWhatCantBeDrawn) {
  Renderer renderer(kSmall);
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  const auto refusal_of = [&](const std::function<void(Drawing&)>& spoil) {
    TestScene scene = test_scene(kAspect);
    spoil(scene.drawing);
    return refusal([&] { renderer.draw(scene.drawing, scene.camera); });
  };
  EXPECT_EQ(refusal_of([](Drawing&) {}), "");
  EXPECT_NE(refusal_of([&](Drawing& d) { d.strands.points[7][1] = nan; }).find("point 7 of the strands"),
            std::string::npos);
  EXPECT_NE(refusal_of([&](Drawing& d) { d.strands.points[7][1] = infinity; }), "");
  EXPECT_NE(refusal_of([](Drawing& d) { d.strands.points.pop_back(); }), "");
  EXPECT_NE(refusal_of([](Drawing& d) { d.strands.sizes[0] = 0; }), "");
  EXPECT_NE(refusal_of([](Drawing& d) { d.strands.sizes.assign(20, 2'000'000'000); }), "");
  EXPECT_NE(refusal_of([&](Drawing& d) { d.tubes[0].b[2] = nan; }), "");
  EXPECT_NE(refusal_of([](Drawing& d) { d.sheets[0].rows = 1'000'000'000; }), "");
  EXPECT_NE(refusal_of([&](Drawing& d) { d.obstacles[0].velocity[0] = nan; }), "");

  Camera nowhere = kFront;
  nowhere.eye = nowhere.target;
  EXPECT_NE(refusal([&] { renderer.draw({}, nowhere); }), "");
  nowhere = kFront;
  nowhere.up = Vector3d(0, 1, 0);
  EXPECT_NE(refusal([&] { renderer.draw({}, nowhere); }), "");
}

TEST(Renderer, SettingsHaveBounds) {
  for (const int side : {-1, 0, 15, 4097, 1'000'000'000}) {
    EXPECT_NE(refusal([&] { Renderer({.width = side, .height = 180}); }), "") << side;
    EXPECT_NE(refusal([&] { Renderer({.width = 320, .height = side}); }), "") << side;
  }
  EXPECT_EQ(Renderer({.width = 16, .height = 16}).draw({}, kFront).width, 16);
}

TEST(Renderer, WithoutOpenGlOneLineNamesThePackage) {
  for (const char* const library : {"libOSMesa.so.not-there", "libEGL.so.not-there", "libm.so.6"}) {
    try {
      Renderer renderer({.library = library});
      FAIL() << library;
    } catch (const NoOpenGl& error) {
      const std::string line = error.what();
      EXPECT_NE(line.find("libosmesa6"), std::string::npos) << line;
      EXPECT_NE(line.find(library), std::string::npos) << line;
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    }
  }
}

}  // namespace
}  // namespace hair
