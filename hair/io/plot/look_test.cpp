// The palettes: contrast (WCAG 2), and differences between colours (CIEDE2000: G. Sharma, W. Wu and E. Dalal,
// "The CIEDE2000 Color-Difference Formula", 2005) for four kinds of sight (G. Machado, M. Oliveira and L.
// Fernandes, "A Physiologically-based Model for Simulation of Color Vision Deficiency", 2009, severity 1).
#include "hair/io/plot/look.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

namespace hair::plot {
namespace {

using Eigen::Array3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d linear(const std::string& hex) {
  Vector3d c;
  for (int i = 0; i < 3; ++i) {
    const double s = std::stoi(hex.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    c[i] = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  }
  return c;
}

double contrast(const std::string& one, const std::string& other) {
  const Vector3d to_light(0.2126, 0.7152, 0.0722);
  const double a = to_light.dot(linear(one)) + 0.05, b = to_light.dot(linear(other)) + 0.05;
  return std::max(a, b) / std::min(a, b);
}

Matrix3d rows(const Array3d& a, const Array3d& b, const Array3d& c) {
  return (Matrix3d() << a.transpose(), b.transpose(), c.transpose()).finished();
}

Array3d lab(const Vector3d& linear) {
  static const Matrix3d kToXyz = rows({0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750},
                                      {0.0193339, 0.1191920, 0.9503041});
  const Array3d xyz = (kToXyz * linear).array() / Array3d(0.95047, 1, 1.08883);
  const Array3d f = xyz.unaryExpr(
      [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; });
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double ciede2000(const Array3d& one, const Array3d& other) {
  constexpr double kDegree = std::numbers::pi / 180;
  const auto seventh = [](double c) {
    return std::sqrt(std::pow(c, 7) / (std::pow(c, 7) + std::pow(25, 7)));
  };
  const double grey = 1.5 - 0.5 * seventh((std::hypot(one[1], one[2]) + std::hypot(other[1], other[2])) / 2);
  const double c1 = std::hypot(grey * one[1], one[2]), c2 = std::hypot(grey * other[1], other[2]);
  const double h1 = std::atan2(one[2], grey * one[1]), h2 = std::atan2(other[2], grey * other[1]);
  const double turn = c1 * c2 == 0 ? 0 : std::remainder(h2 - h1, 360 * kDegree);
  const double l = (one[0] + other[0]) / 2 - 50, c = (c1 + c2) / 2, h = (h1 + turn / 2) / kDegree;
  const double t = 1 - 0.17 * std::cos((h - 30) * kDegree) + 0.24 * std::cos(2 * h * kDegree) +
                   0.32 * std::cos((3 * h + 6) * kDegree) - 0.2 * std::cos((4 * h - 63) * kDegree);
  const double blue = std::remainder(h - 275, 360) / 25;
  const double mixed = -2 * seventh(c) * std::sin(60 * kDegree * std::exp(-blue * blue));
  const double light = (other[0] - one[0]) / (1 + 0.015 * l * l / std::sqrt(20 + l * l));
  const double chroma = (c2 - c1) / (1 + 0.045 * c);
  const double hue = 2 * std::sqrt(c1 * c2) * std::sin(turn / 2) / (1 + 0.015 * c * t);
  return std::sqrt(light * light + chroma * chroma + hue * hue + mixed * chroma * hue);
}

struct Sight {
  const char* name;
  Matrix3d seen;  // multiplies linear colours
};
const Sight kSights[] = {{"normal", Matrix3d::Identity()},
                         {"protan", rows({0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216},
                                         {-0.003882, -0.048116, 1.051998})},
                         {"deutan", rows({0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413},
                                         {-0.011820, 0.042940, 0.968881})},
                         {"tritan", rows({1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602},
                                         {0.004733, 0.691367, 0.303900})}};

TEST(LookTest, ColoursStandOutFromThePaperAndFromEachOtherForEachKindOfSight) {
  // Pairs of Sharma, Wu and Dalal's table 1.
  EXPECT_NEAR(ciede2000({50, 2.6772, -79.7751}, {50, 0, -82.7485}), 2.0425, 1e-4);
  EXPECT_NEAR(ciede2000({50, -1, 2}, {50, 0, 0}), 2.3669, 1e-4);
  EXPECT_NEAR(ciede2000({50, 2.5, 0}, {61, -5, 29}), 22.8977, 1e-4);
  for (const bool dark : {false, true}) {
    const auto shown = [&](const char* light) { return dark ? in_the_dark(light) : light; };
    for (int i = 0; i < kColours; ++i) {
      EXPECT_GE(contrast(shown(colour(i)), shown(kPaper)), 4.5) << i << (dark ? ", dark" : ", light");
      for (int j = 0; j < i; ++j)
        for (const Sight& sight : kSights) {
          const auto seen = [&](int series) {
            return lab((sight.seen * linear(shown(colour(series)))).cwiseMax(0).cwiseMin(1));
          };
          EXPECT_GE(ciede2000(seen(i), seen(j)), 15)
              << i << " and " << j << ", " << sight.name << (dark ? ", dark" : ", light");
        }
    }
    for (const char* text : {kText, kQuiet}) EXPECT_GE(contrast(shown(text), shown(kPaper)), 4.5);
  }
}

TEST(LookTest, TheFirst88SeriesHaveEachAColourAndMarkerOfTheirOwn) {
  std::set<std::pair<std::string, std::string>> looks;
  std::set<std::string> markers, all_dashes;
  for (int i = 0; i < kColours * kMarkers; ++i) {
    looks.insert({colour(i), marker_path(i, 4.5)});
    markers.insert(marker_path(i, 4.5));
    all_dashes.insert(dashes(i));
  }
  EXPECT_EQ(looks.size(), kColours * kMarkers);
  EXPECT_EQ(markers.size(), kMarkers);
  EXPECT_EQ(all_dashes.size(), kColours);
}

}  // namespace
}  // namespace hair::plot
