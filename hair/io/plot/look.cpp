#include "hair/io/plot/look.h"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "hair/io/plot/xml.h"

namespace hair::plot {

namespace {

struct Themes {
  const char *light, *dark;
};

// The series' colours come first.
constexpr Themes kThemes[] = {{"#046dfd", "#8db1ff"}, {"#c55307", "#f47b30"}, {"#1b7c5c", "#32eea7"},
                              {"#a06095", "#dea8bf"}, {"#000000", "#fbffff"}, {"#583b00", "#ffec46"},
                              {"#4b525b", "#79828b"}, {"#5c18b6", "#9565ef"}, {kPaper, "#15181d"},
                              {kText, "#e4e7eb"},     {kFaint, "#333a45"},    {kSoft, "#1d2128"},
                              {kMiddle, "#8a93a0"},   {kQuiet, "#a0a9b6"}};

struct Corner {
  double x, y;
};

std::string outline(const std::vector<Corner>& corners, double scale) {
  std::string path;
  for (const Corner& corner : corners)
    path += (path.empty() ? "M" : "L") + pixels(scale * corner.x) + " " + pixels(scale * corner.y);
  return path + "Z";
}

// `corners` of them on circles with the radii `outer` and `inner` in turn, the first one upwards, turned by
// `turn`.
std::string star(int corners, double outer, double inner, double turn, double scale) {
  std::vector<Corner> all;
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + 2 * std::numbers::pi * i / corners, radius = i % 2 == 0 ? outer : inner;
    all.push_back({radius * std::sin(angle), -radius * std::cos(angle)});
  }
  return outline(all, scale);
}

// A plus with arms as wide as `arm`, turned by 0 or 45 degrees.
std::string cross(bool turned, double scale) {
  constexpr double kArm = 0.38, kEnd = 1.1;
  std::vector<Corner> corners = {{-kArm, -kEnd}, {kArm, -kEnd}, {kArm, -kArm},  {kEnd, -kArm},
                                 {kEnd, kArm},   {kArm, kArm},  {kArm, kEnd},   {-kArm, kEnd},
                                 {-kArm, kArm},  {-kEnd, kArm}, {-kEnd, -kArm}, {-kArm, -kArm}};
  if (turned)
    for (Corner& corner : corners)
      corner = {(corner.x - corner.y) / std::numbers::sqrt2, (corner.x + corner.y) / std::numbers::sqrt2};
  return outline(corners, scale);
}

std::string circle(double radius) {
  const std::string r = pixels(radius), arc = "A" + r + " " + r + " 0 1 1 ";
  return "M" + pixels(-radius) + " 0" + arc + r + " 0" + arc + pixels(-radius) + " 0Z";
}

}  // namespace

const char* colour(int series) {
  return kThemes[series % kColours].light;
}

std::string in_the_dark(const std::string& light) {
  for (const Themes& themes : kThemes)
    if (light == themes.light) return themes.dark;
  throw std::invalid_argument(light + " is no colour of the themes");
}

std::string dark_style() {
  std::string rules;
  for (const auto& [light, dark] : kThemes)
    for (const std::string property : {"fill", "stroke"})
      rules += "[" + property + "=\"" + light + "\"]{" + property + ":" + dark + "}";
  return "@media screen and (prefers-color-scheme:dark){" + rules + "}";
}

std::string marker_path(int series, double radius) {
  using std::numbers::pi;
  switch (series % kMarkers) {
    case 0:
      return circle(radius);
    case 1:
      return outline({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}}, radius);
    case 2:
      return star(3, 1.3, 1.3, 0, radius);
    case 3:
      return outline({{0, -1.3}, {1, 0}, {0, 1.3}, {-1, 0}}, radius);
    case 4:
      return cross(false, radius);
    case 5:
      return star(3, 1.3, 1.3, pi, radius);
    case 6:
      return star(10, 1.4, 0.58, 0, radius);
    case 7:
      return cross(true, radius);
    case 8:
      return star(3, 1.3, 1.3, pi / 2, radius);
    case 9:
      return star(6, 1.15, 1.15, pi / 6, radius);
    default:
      return outline({{-1.2, -0.55}, {1.2, -0.55}, {1.2, 0.55}, {-1.2, 0.55}}, radius);
  }
}

const char* dashes(int dashed_curve) {
  constexpr std::array<const char*, kColours> kDashes = {"7 4", "2 3", "9 3 2 3",      "12 5",
                                                         "4 2", "1 5", "12 3 2 3 2 3", "5 7"};
  return kDashes[dashed_curve % kDashes.size()];
}

}  // namespace hair::plot
