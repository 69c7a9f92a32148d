#include "hair/render/light.h"

#include <algorithm>
#include <cmath>

namespace hair {
namespace {

const Eigen::Vector3f kTarget(0, 0, -1);
constexpr float kLargest = 2;  // times the distance to the target: no shadows of objects farther away

}  // namespace

LightMap light_map(const std::vector<RibbonVertex>& ribbons, const Mesh& mesh,
                   std::span<const Eigen::Vector3f> points) {
  const Eigen::Vector3f across = Eigen::Vector3f(0, 1, 0).cross(kKeyLight).normalized();
  const Eigen::Vector3f up = kKeyLight.cross(across);
  float radius = 0;
  const auto add = [&](const Eigen::Vector3f& at) {
    const float distance = std::max(std::abs(across.dot(at - kTarget)), std::abs(up.dot(at - kTarget)));
    if (distance < kLargest) radius = std::max(radius, distance);
  };
  for (const RibbonVertex& vertex : ribbons) add(vertex.at);
  for (const Eigen::Vector3f& point : points) add(point);
  for (const MeshVertex& vertex : mesh.vertices) {
    if (vertex.ground == 0) add(vertex.at);
  }
  LightMap map;
  map.radius = kLargest;
  while (map.radius > 1e-3F && 1.05F * radius < map.radius / std::sqrt(2.0F)) map.radius /= std::sqrt(2.0F);
  map.to = Eigen::Matrix4f::Identity();
  map.to.block<1, 3>(0, 0) = across.transpose() / map.radius;
  map.to.block<1, 3>(1, 0) = up.transpose() / map.radius;
  map.to.block<1, 3>(2, 0) = -kKeyLight.transpose() / LightMap::kDepth;
  map.to.block<3, 1>(0, 3) = -map.to.block<3, 3>(0, 0) * kTarget;
  return map;
}

}  // namespace hair
