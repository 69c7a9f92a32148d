// STAFF ONLY. H10's figure: weights inside and beside an obtuse triangle, and four tufts.
#include <filesystem>
#include <map>

#include "hair/dense/synthesis.h"
#include "hair/scene/scene_run.h"
#include "hair/strand_synthesis.h"
#include "reference/figures/drawing.h"

namespace figures {
namespace {

// The colours of the three guides, mixed; with large letters, for it is the same in dark pages.
std::string mixed(const std::array<int, 3>& eighths) {
  std::string text = "#";
  for (int channel = 0; channel < 3; ++channel) {
    int sum = 0;
    for (int k = 0; k < 3; ++k)
      sum += eighths[k] * std::stoi(std::string(colour(k)).substr(1 + 2 * channel, 2), nullptr, 16);
    for (const int digit : {sum / 8 / 16, sum / 8 % 16}) text += "0123456789ABCDEF"[digit];
  }
  return text;
}

// Weights in eighths: cells of the same weights are one path, and their edges are lines of equal weight.
void draw_weights(Drawing& drawing) {
  const std::array<Vector3d, 3> corners = {Vector3d(200, 200, 0), Vector3d(500, 220, 0),
                                           Vector3d(110, 70, 0)};
  const auto weights_at = [&](double x, double y) { return hair::root_weights(corners, {x, y, 0}); };
  constexpr int kCell = 6, kLeft = 18, kRight = 702, kTop = 10, kBottom = 280;
  std::map<std::array<int, 3>, std::string> paths;
  for (int y = kTop; y < kBottom; y += kCell) {
    const auto eighths_at = [&](int x) {
      const std::array<double, 3> weights = weights_at(x + kCell / 2.0, y + kCell / 2.0);
      std::array<int, 3> eighths;
      for (int k = 0; k < 2; ++k) eighths[k] = static_cast<int>(std::lround(8 * weights[k]));
      eighths[2] = std::max(0, 8 - eighths[0] - eighths[1]);
      return eighths;
    };
    for (int x = kLeft, end = x; x < kRight; x = end) {
      const std::array<int, 3> eighths = eighths_at(x);
      while (end < kRight && eighths_at(end) == eighths) end += kCell;
      const std::string wide = std::to_string(end - x), high = std::to_string(kCell);
      paths[eighths] +=
          "M" + std::to_string(x) + " " + std::to_string(y) + "h" + wide + "v" + high + "h-" + wide + "z";
    }
  }
  for (const auto& [eighths, path] : paths) drawing.path(path, mixed(eighths), 0.55);
  const auto spot = [&](int k) { return Spot(corners[k][0], corners[k][1]); };
  drawing.line({spot(0), spot(1), spot(2), spot(0), spot(1)}, {kText, 2.5});
  for (const Spot& root : {Spot(262, 180), Spot(400, 80), Spot(90, 190), Spot(370, 250)}) {
    const std::array<double, 3> weights = weights_at(root[0], root[1]);
    const Spot nearest = weights[0] * spot(0) + weights[1] * spot(1) + weights[2] * spot(2);
    if ((nearest - root).norm() > 1) drawing.arrow(root, nearest, {kText, 2});
    drawing.dot(root, kText, 5);
    for (int k = 0; k < 3; ++k)
      drawing.words(root + Spot(-56 + 38 * k, root[1] > 185 ? 22 : -10), fixed(weights[k], 2),
                    {colour(k), "start", 14, "bold"});
  }
  for (int k = 0; k < 3; ++k) drawing.dot(spot(k), colour(k), 9);
}

// The strands with a root in the middle of a tuft, from the front.
void draw_tuft(Drawing& drawing, const Spot& at, double middle, std::span<const double> points, double deep) {
  constexpr std::size_t kNumbers = 3 * 29;
  const View view = {at, 1350, {middle, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  std::vector<Spots> strands;
  for (std::size_t strand = 0; strand < points.size(); strand += kNumbers) {
    if (std::abs(points[strand + 1]) > deep) continue;
    for (Spots& spots = strands.emplace_back(); spots.size() < kNumbers / 3;)
      spots.push_back(view(Eigen::Map<const Vector3d>(&points[strand + 3 * spots.size()])));
  }
  drawing.lines(strands, {colour(7), 1.3});
}

}  // namespace

std::string draw_h10() {
  Drawing drawing("H10", 490, "Which guides make a hair, and what becomes of their curls?",
                  "Weights of three guides in and around an obtuse triangle; tufts of guides and of hair.");
  draw_weights(drawing);
  const hair::Scene scene = hair::read_scene(std::filesystem::path(HAIR_SCENES_DIR) / "guides-to-hair.json");
  const VectorXd x = hair::SceneRun(scene).state().x;
  const std::size_t group = static_cast<std::size_t>(x.size()) / 4;
  const char* const names[] = {"guides", "interpolated", "extrapolated", "a blend"};
  for (std::size_t i = 0; i < 4; ++i) {
    const Spot at(100 + 173.0 * static_cast<double>(i), 320);
    const double middle = -0.15 + 0.1 * static_cast<double>(i);
    const std::span<const double> guides(x.data() + i * group, group);
    if (i == 0) {
      draw_tuft(drawing, at, middle, guides, 0.006);
    } else {
      hair::Synthesis synthesis(scene.dense[i - 1].description);
      std::vector<double> children(static_cast<std::size_t>(3 * synthesis.children() * synthesis.points()));
      synthesis.make(guides, Eigen::Matrix3d::Identity(), {}, std::span(children));
      draw_tuft(drawing, at, middle, children, 0.001);
    }
    drawing.words(at + Spot(0, -18), names[i]);
  }
  return drawing.svg();
}

}  // namespace figures
