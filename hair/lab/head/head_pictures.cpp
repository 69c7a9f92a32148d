#include "hair/lab/head/head_pictures.h"

#include <algorithm>

#include "hair/head/hair_colours.h"

namespace hair::head_study {
namespace {

constexpr int kWidth = 640, kHeight = 720, kCells = 220;
const Vector3d kView(0.85, 0.6, 0.2);
constexpr double kChin = -0.13;  // m: the picture shows the body below only as far as hair reaches

// A head has a hundred thousand hairs of 80 micrometres. Fewer are drawn wider, so that they cover it as
// well, but not wider than this.
constexpr double kHairWidth = 8e-5, kFullHead = 1e5, kWidest = 8e-4;

Colour linear_colour(const std::array<double, 3>& parts) {
  return Eigen::Vector3d(parts[0], parts[1], parts[2]).cast<float>();
}

int or_nearest(const std::vector<int>& guides, int wanted, int otherwise) {
  return std::ranges::find(guides, wanted) != guides.end() ? wanted : otherwise;
}

}  // namespace

HeadPictures::HeadPictures(const Bust& bust)
    : renderer_({.width = kWidth, .height = kHeight}),
      mesh_(std::make_shared<SurfaceMesh>(surface_net(bust, kCells))) {}

Image HeadPictures::draw(std::span<const double> points, int points_of_strand) {
  const Way way = way_at(turn_of_head(), kPictured / kFramesPerSecond);
  const std::size_t strands = points.size() / (3 * static_cast<std::size_t>(points_of_strand));
  const HairColour& colour = kHairColours[2];  // chestnut
  Drawing drawing;
  StrandsDrawing& hair = drawing.strands;
  hair.fine = true;
  hair.width = std::clamp(kHairWidth * kFullHead / static_cast<double>(strands), kHairWidth, kWidest);
  hair.root = linear_colour(colour.root);
  hair.tip = linear_colour(colour.tip);
  hair.sizes.assign(strands, points_of_strand);
  for (std::size_t at = 0; at < points.size(); at += 3)
    hair.points.emplace_back(points[at], points[at + 1], points[at + 2]);
  drawing.meshes.push_back({mesh_, way(Vector3d::Zero()), way.rotation});
  if (!camera_) {
    std::vector<Vector3d> seen = hair.points;
    for (const Vector3d& point : mesh_->points)
      if (point.z() > kChin) seen.push_back(way(point));
    camera_ = frame_points(seen, static_cast<double>(kWidth) / kHeight, kView);
  }
  return renderer_.draw(drawing, *camera_);
}

PicturedGuides pictured_guides(const std::vector<int>& guides) {
  if (guides.empty()) return {0, 0};
  return {or_nearest(guides, 100, guides.front()), or_nearest(guides, 1'000, guides.back())};
}

}  // namespace hair::head_study
