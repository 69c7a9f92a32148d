// STAFF ONLY. Fine hair: its coverage, its opacity, its light.
#include "hair/render/fine/fine_hair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hair/render/light.h"
#include "hair/render/opengl/renderer.h"

namespace hair {
namespace {

constexpr int kSide = 128;  // pixels

// One metre from the origin, on the y axis: x is to the right, z up.
const Camera kAhead{.eye = Vector3d(0, -1, 0), .target = Vector3d::Zero(), .up = Vector3d(0, 0, 1)};
const double kFinePixel = 2 * std::tan(kAhead.field_of_view / 2) / kSide;  // m, at the origin

StrandsDrawing fine(const std::vector<std::vector<Vector3d>>& lines, double width) {
  StrandsDrawing strands;
  strands.fine = true;
  strands.width = width;
  for (const auto& line : lines) {
    strands.sizes.push_back(static_cast<int>(line.size()));
    strands.points.insert(strands.points.end(), line.begin(), line.end());
  }
  return strands;
}

HairLayer layer_of(const StrandsDrawing& strands, int threads = 1) {
  FineHair hair(threads);
  const View view(kAhead, 1);
  hair.send(strands, view, kSide);
  return hair.draw(strands, view, kSide, kSide, {});
}

double covered(const HairLayer& layer, int x, int y) {
  return 1 - layer.pixels[4 * static_cast<std::size_t>(y * layer.width + x) + 3];
}

// A long strand through the picture's middle, `shift` pixels away from it, at `angle` from upright. Its tip
// is far outside, so that the visible part is not tapered.
StrandsDrawing slanted(double width, double shift, double angle) {
  const Vector3d along(std::sin(angle), 0, std::cos(angle)), across(std::cos(angle), 0, -std::sin(angle));
  const Vector3d middle = shift * kFinePixel * across;
  return fine({{middle + 0.4 * along, middle - 4 * along}}, width * kFinePixel);
}

// Each row (or column) that a strand crosses is covered by the length of its cut, w / cos(angle), in total:
// the tents of a row's pixels add up to 1 everywhere. Rounding: positions have errors of 2^-24 of some
// hundred pixels, as floats have, and a tent's slope is at most 1.
TEST(FineHair, CoversItsWidthWhereverItLies) {
  for (const double width : {0.02, 0.2, 0.9, 1.0, 3.7})
    for (const double angle : {0.0, 0.2, 0.7})
      for (const double shift : {0.0, 0.13, 0.5, 0.77}) {
        const HairLayer layer = layer_of(slanted(width, shift, angle));
        for (const int y : {20, 64, 101}) {
          double sum = 0;
          for (int x = 0; x < kSide; ++x) sum += covered(layer, x, y);
          EXPECT_NEAR(sum, width / std::cos(angle), 2e-4 * (1 + width))
              << "width " << width << ", angle " << angle << ", shift " << shift << ", row " << y;
        }
      }
}

// The same for a strand whose pieces meet in the picture: a joint is neither gap nor bead. The bend is
// slight, so that all pieces are more upright than level, and a cut's length is between those for both ends'
// angles.
TEST(FineHair, HasNoBeadsWherePiecesMeet) {
  std::vector<Vector3d> arc;
  for (int i = 0; i <= 40; ++i) {
    const double angle = 0.3 * (i / 40.0 - 0.5);
    arc.emplace_back(1.2 * (1 - std::cos(angle)), 0, 1.2 * std::sin(-angle));
  }
  for (int i = 1; i <= 40; ++i) arc.emplace_back(arc.back() + Vector3d(0.02, 0, -0.2));
  const HairLayer layer = layer_of(fine({arc}, 0.6 * kFinePixel));
  for (int y = 30; y < kSide - 30; ++y) {
    double sum = 0;
    for (int x = 0; x < kSide; ++x) sum += covered(layer, x, y);
    EXPECT_GE(sum, 0.6 * (1 - 1e-3)) << "row " << y;
    EXPECT_LE(sum, 0.6 / std::cos(0.15) * (1 + 1e-3)) << "row " << y;
  }
}

// Strands behind one another let through the product of their transparencies.
TEST(FineHair, LiesOverWhatIsBehind) {
  std::vector<std::vector<Vector3d>> lines;
  for (int i = 0; i < 5; ++i) lines.push_back({Vector3d(0, 1e-3 * i, 0.4), Vector3d(0, 1e-3 * i, -4)});
  const HairLayer one = layer_of(fine({lines[0]}, 0.4 * kFinePixel)),
                  all = layer_of(fine(lines, 0.4 * kFinePixel));
  for (int x = kSide / 2 - 2; x < kSide / 2 + 2; ++x)
    // Distances differ by up to 4e-3, and so do widths.
    EXPECT_NEAR(1 - covered(all, x, 64), std::pow(1 - covered(one, x, 64), 5), 0.01) << "column " << x;
}

TEST(FineHair, TapersToItsTip) {
  const HairLayer layer =
      layer_of(fine({{Vector3d(0, 0, 60 * kFinePixel), Vector3d(0, 0, -60 * kFinePixel)}}, 0.8 * kFinePixel));
  const auto at = [&](double along) {
    const int y = 64 + 60 - static_cast<int>(120 * along);
    return covered(layer, 63, y) + covered(layer, 64, y);
  };
  EXPECT_NEAR(at(0.5), 0.8, 0.01);
  // In the middle of the taper the strand has half of its width. A row's middle is up to one and a half
  // pixels from the requested point.
  const double pixel = 0.8 / (FineStrands::kTaper * 120);
  EXPECT_NEAR(at(1 - FineStrands::kTaper / 2), 0.4, 1.5 * pixel);
  EXPECT_LT(at(0.99), (0.01 * 120 + 1.5) * pixel);
}

std::vector<std::vector<Vector3d>> tuft(int count) {
  std::vector<std::vector<Vector3d>> lines;
  for (int i = 0; i < count; ++i) {
    std::vector<Vector3d> line;
    for (int k = 0; k < 12; ++k)
      line.emplace_back(0.15 * std::sin(2.4 * i) + 0.02 * std::sin(0.9 * k + i), 0.1 * std::cos(1.7 * i),
                        0.2 - 0.03 * k);
    lines.push_back(line);
  }
  return lines;
}

TEST(FineHair, HasTheSameBitsWithAnyThreads) {
  const StrandsDrawing strands = fine(tuft(500), 1e-3);
  const View view(kAhead, 1);
  HairLayer layers[2];
  std::vector<float> maps[2];
  for (const int i : {0, 1}) {
    FineHair hair(i == 0 ? 1 : 3);
    hair.send(strands, view, kSide);
    hair.make_opacity(light_map({}, {}, hair.points()), 256);
    maps[i] = hair.opacity().opacity();
    layers[i] = hair.draw(strands, view, kSide, kSide, {});
  }
  EXPECT_EQ(maps[0], maps[1]);
  EXPECT_EQ(layers[0].pixels, layers[1].pixels);
}

// Sheets of parallel strands across the light, one behind the other. Strands of width w, s apart, cover the
// part w / s of the light: the opacity behind k sheets is k w / s, and exp(-k w / s) of the light passes. A
// sheet is rounded to 1/16384 of a texel for each strand in a texel, and 20 strands to a texel's width make
// the map even to about one in 20.
TEST(OpacityMap, OfAStackOfSheetsIsTheSum) {
  const Eigen::Vector3d light = kKeyLight.cast<double>();
  // The camera's axes: x, z up, -y back; the view's light (x, y, z) is (x, -z, y) in space.
  const Vector3d to_light(light[0], -light[2], light[1]);
  const Vector3d across = Vector3d(0, 0, 1).cross(to_light).normalized(), over = to_light.cross(across);
  constexpr double kApart = 2e-4, kWidth = 5e-5, kHalf = 0.1;
  std::vector<std::vector<Vector3d>> lines;
  constexpr int kSheets = 6;
  for (int sheet = 0; sheet < kSheets; ++sheet)
    for (double x = -kHalf; x <= kHalf; x += kApart) {
      const Vector3d middle = x * across - 0.004 * sheet * to_light;
      // Long tips, so that the taper is outside of the measured part of the sheet.
      lines.push_back({middle + kHalf * over, middle - 2 * kHalf * over});
    }
  const StrandsDrawing strands = fine(lines, kWidth);
  const View view(kAhead, 1);
  FineHair hair(2);
  hair.send(strands, view, kSide);
  hair.make_opacity(light_map({}, {}, hair.points()), 128);
  const OpacityMap& map = hair.opacity();
  for (const double x : {-0.03, 0.0, 0.041}) {
    const auto opacity_at = [&](double depth) { return map.before(view.at(x * across - depth * to_light)); };
    EXPECT_EQ(opacity_at(-0.01), 0) << "before all hair";
    EXPECT_NEAR(opacity_at(0.3), kSheets * kWidth / kApart, 0.05 * kSheets * kWidth / kApart);
    // Between the sheets the opacity grows with the depth.
    for (int sheet = 0; sheet < kSheets; ++sheet)
      EXPECT_LE(opacity_at(0.004 * sheet + 0.002), opacity_at(0.004 * sheet + 0.006) + 1e-6);
  }
}

// A strand that the camera doesn't see has a shadow, too.
TEST(OpacityMap, HasHairThatNoCameraSees) {
  const View view(kAhead, 1);
  const Vector3d to_light(kKeyLight[0], -kKeyLight[2], kKeyLight[1]);
  FineHair hair(1);
  std::vector<std::vector<Vector3d>> lines;
  const Vector3d far = 1.2 * to_light;
  for (int i = -50; i <= 50; ++i)
    lines.push_back({far + Vector3d(1e-3 * i, 0, 0.3), far + Vector3d(1e-3 * i, 0, -0.3)});
  const StrandsDrawing strands = fine(lines, 1e-3);
  hair.send(strands, view, kSide);
  hair.make_opacity(light_map({}, {}, hair.points()), 256);
  EXPECT_GT(hair.opacity().before(view.at(Vector3d::Zero())), 0.5);
  const HairLayer layer = hair.draw(strands, view, kSide, kSide, {});
  for (int i = 0; i < kSide * kSide; ++i) ASSERT_EQ(layer.pixels[4 * static_cast<std::size_t>(i) + 3], 1);
}

// The mean of sin(T, L) over all directions of light is pi / 4: the integral of sin^2 is pi / 2, over 2.
TEST(KajiyaKay, DiffuseLightIsTheSine) {
  const Eigen::Vector3f t(0, 0, 1);
  double sum = 0;
  constexpr int kSteps = 2000;
  for (int i = 0; i < kSteps; ++i) {
    const double angle = std::numbers::pi * (i + 0.5) / kSteps;
    const Eigen::Vector3f light(static_cast<float>(std::sin(angle)), 0, static_cast<float>(std::cos(angle)));
    sum += kajiya_diffuse(t, light) * std::sin(angle) / 2 * std::numbers::pi / kSteps;
    // At small sines, 1 - cos^2 has lost half of a float's digits.
    EXPECT_NEAR(kajiya_diffuse(t, light), std::sin(angle), 4e-4);
  }
  EXPECT_NEAR(sum, std::numbers::pi / 4, 1e-5);
}

// A highlight is brightest if light leaves in the mirrored direction. Shifting the tangent by s moves this
// direction by atan(s), and at an angle a from it the highlight is cos(a)^p.
TEST(KajiyaKay, HighlightsAreOnTheCone) {
  const Eigen::Vector3f t(0, 0, 1), across(1, 0, 0);
  for (const double shift : {-0.12, 0.0, 0.16})
    for (const double angle : {0.0, 0.1, 0.4}) {
      // Perpendicular to the shifted tangent, and `angle` away from it.
      const double turned = std::atan(shift) + angle;
      const Eigen::Vector3f half_way(static_cast<float>(std::cos(turned)), 0,
                                     static_cast<float>(-std::sin(turned)));
      EXPECT_NEAR(shifted_highlight(t, across, half_way, static_cast<float>(shift), 24),
                  std::pow(std::cos(angle), 24), 1e-5)
          << shift << ", " << angle;
    }
}

TEST(FineHair, KeepsAStrandsColour) {
  StrandsDrawing strands;
  const StrandTint one = strand_tint(strands, 7), same = strand_tint(strands, 7),
                   other = strand_tint(strands, 8);
  EXPECT_EQ(one.root, same.root);
  EXPECT_NE(one.root, other.root);
}

// The whole picture has the same bytes when drawn twice, with solids in it, and after other drawings.
TEST(FineHair, IsDrawnWithTheSameBytesAgain) {
  Drawing drawing;
  drawing.strands = fine(tuft(300), 1e-3);
  drawing.balls.push_back({Vector3d(0, 0, 0), 0.08, Colour(0.5F, 0.4F, 0.3F)});
  Renderer renderer({.width = 160, .height = 120});
  const Image first = renderer.draw(drawing, kAhead);
  Drawing ribbons = drawing;
  ribbons.strands.fine = false;
  const Image plain = renderer.draw(ribbons, kAhead);
  EXPECT_FALSE(plain == first);
  EXPECT_TRUE(renderer.draw(drawing, kAhead) == first);
  EXPECT_TRUE(Renderer({.width = 160, .height = 120}).draw(ribbons, kAhead) == plain);
  EXPECT_TRUE(Renderer({.width = 160, .height = 120}).draw(drawing, kAhead) == first);
}

// A red ball in front of a wall of black hair: at its edge pixels are between red and black, and never as
// bright as the background.
TEST(FineHair, LeavesNoFringeAtASolidsEdge) {
  Drawing drawing;
  drawing.balls.push_back({Vector3d(0, 0, 0), 0.1, Colour(0.3F, 0, 0)});
  std::vector<std::vector<Vector3d>> wall;
  for (int i = -200; i <= 200; ++i)
    wall.push_back({Vector3d(1e-3 * i, 0.15, 0.4), Vector3d(1e-3 * i, 0.15, -4)});
  drawing.strands = fine(wall, 4e-3);
  drawing.strands.root = drawing.strands.tip = Colour::Zero();
  const Image image = Renderer({.width = 160, .height = 120, .shadows = false}).draw(drawing, kAhead);
  // A ball's side has at most its own highlight in blue; the background has more than 180.
  for (int x = 45; x < 115; ++x) EXPECT_LT(image.at(x, 60)[2], 110) << x;
}

// Hair behind a ball is not seen, hair before it is.
TEST(FineHair, IsHiddenBySolids) {
  Drawing drawing;
  drawing.balls.push_back({Vector3d(0, 0, 0), 0.1, Colour(0.5F, 0, 0)});
  Renderer renderer({.width = 160, .height = 120, .shadows = false});
  const Image ball = renderer.draw(drawing, kAhead);
  const auto reds = [&](double y) {
    drawing.strands = fine({{Vector3d(0, y, 0.09), Vector3d(0, y, -0.5)}}, 0.02);
    drawing.strands.root = drawing.strands.tip = Colour::Zero();
    return static_cast<int>(renderer.draw(drawing, kAhead).at(80, 60)[0]);
  };
  EXPECT_EQ(reds(0.2), ball.at(80, 60)[0]);
  EXPECT_LT(reds(-0.2), ball.at(80, 60)[0] / 2);
}

}  // namespace
}  // namespace hair
