#include "hair/render/mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hair {
namespace {

const Colour kSkin(0.50F, 0.40F, 0.34F);
const Colour kGround(0.62F, 0.63F, 0.65F);
constexpr float kGroundRadius = 6;  // times the distance to the target

class MeshBuilder {
 public:
  MeshBuilder(const View& view, int samples) : view_(view), samples_(samples) {}

  // Adds a grid of corners, with two triangles between each four. `at` and `normal` are in the view's axes.
  template <class Vertex>
  void grid(int rows, int columns, Vertex vertex) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int r = 0; r < rows; ++r) {
      for (int c = 0; c < columns; ++c) mesh.vertices.push_back(vertex(r, c));
    }
    for (int r = 0; r + 1 < rows; ++r) {
      for (int c = 0; c + 1 < columns; ++c) {
        const auto i = first + static_cast<std::uint32_t>(r * columns + c);
        const auto below = i + static_cast<std::uint32_t>(columns);
        for (const std::uint32_t index : {i, i + 1, below, below, i + 1, below + 1})
          mesh.indices.push_back(index);
      }
    }
  }

  // All points within `radius` of the line from a to b; a ball if a is b.
  void capsule(const Vector3d& a, const Vector3d& b, double radius, const Colour& colour) {
    const int corners = corners_of(a, b, radius), rings = corners / 2 + 2;
    const Vector3d axis = b == a ? Vector3d(0, 0, 1) : Vector3d((b - a).normalized());
    const Vector3d across = axis.unitOrthogonal(), over = axis.cross(across);
    grid(rings, corners + 1, [&](int r, int c) {
      const bool upper = r > corners / 4;
      const double polar = std::numbers::pi * (upper ? r - 1 : r) / (rings - 2) - std::numbers::pi / 2;
      const double around = 2 * std::numbers::pi * (c % corners) / corners;
      const Vector3d normal =
          std::sin(polar) * axis + std::cos(polar) * (std::cos(around) * across + std::sin(around) * over);
      return MeshVertex{view_.at((upper ? b : a) + radius * normal), view_.direction(normal), colour};
    });
  }

  void ring(const Ring& ring) {
    const int corners = corners_of(ring.centre, ring.centre, ring.radius + ring.thickness);
    const int thin = corners_of(ring.centre, ring.centre, ring.thickness);
    const Vector3d axis = ring.normal.normalized(), across = axis.unitOrthogonal(), over = axis.cross(across);
    grid(corners + 1, thin + 1, [&](int r, int c) {
      const double around = 2 * std::numbers::pi * (r % corners) / corners;
      const double turn = 2 * std::numbers::pi * (c % thin) / thin;
      const Vector3d out = std::cos(around) * across + std::sin(around) * over;
      const Vector3d normal = std::cos(turn) * out + std::sin(turn) * axis;
      return MeshVertex{view_.at(ring.centre + ring.radius * out + ring.thickness * normal),
                        view_.direction(normal), ring.colour};
    });
  }

  void sheet(const Sheet& sheet) {
    const auto point = [&](int r, int c) {
      r = std::clamp(r, 0, sheet.rows - 1);
      c = std::clamp(c, 0, sheet.columns - 1);
      return view_.at(sheet.points[static_cast<std::size_t>(r) * static_cast<std::size_t>(sheet.columns) +
                                   static_cast<std::size_t>(c)]);
    };
    grid(sheet.rows, sheet.columns, [&](int r, int c) {
      const Eigen::Vector3f down = point(r + 1, c) - point(r - 1, c),
                            right = point(r, c + 1) - point(r, c - 1);
      const Eigen::Vector3f normal = down.cross(right);
      const float size = normal.norm();
      return MeshVertex{point(r, c), size > 0 ? Eigen::Vector3f(normal / size) : Eigen::Vector3f(0, 0, 1),
                        sheet.colour};
    });
  }

  void placed(const PlacedMesh& placed, const Colour& colour) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::size_t i = 0; i < placed.mesh->points.size(); ++i)
      mesh.vertices.push_back({view_.at(placed.at + placed.rotation * placed.mesh->points[i]),
                               view_.direction(placed.rotation * placed.mesh->normals[i]), colour});
    for (const auto& triangle : placed.mesh->triangles)
      for (const std::uint32_t corner : triangle) mesh.indices.push_back(first + corner);
  }

  // Visible only from above, around the camera's target.
  void ground(const Plane& plane) {
    const Eigen::Vector3f normal = view_.direction(plane.normal);
    const float height = -normal.dot(view_.at(plane.point));
    if (!(height > 0)) return;
    const Eigen::Vector3f target(0, 0, -1);
    const Eigen::Vector3f centre = target - (normal.dot(target) + height) * normal;
    const Eigen::Vector3f across = normal.unitOrthogonal(), over = normal.cross(across);
    grid(2, 2, [&](int r, int c) {
      const Eigen::Vector3f to =
          static_cast<float>(2 * r - 1) * across + static_cast<float>(2 * c - 1) * over;
      return MeshVertex{centre + kGroundRadius * to, normal, kGround, 1};
    });
  }

  Mesh mesh;

 private:
  // A polygon of n corners is r (1 - cos(pi / n)) inside its circle.
  int corners_of(const Vector3d& a, const Vector3d& b, double radius) const {
    const double nearest = std::min(-view_.at(a)[2], -view_.at(b)[2]) - view_.length(radius);
    const double on_screen =
        view_.length(radius) / std::max(nearest, 0.01) / (2 * view_.tangent_y()) * samples_;
    const int corners = static_cast<int>(std::ceil(std::numbers::pi * std::sqrt(on_screen / 0.2)));
    return std::clamp((corners + 3) / 4 * 4, 12, 256);
  }

  const View& view_;
  int samples_;
};

}  // namespace

Mesh mesh_of(const Drawing& drawing, const View& view, int samples) {
  MeshBuilder builder(view, samples);
  for (const Tube& tube : drawing.tubes) builder.capsule(tube.a, tube.b, tube.radius, tube.colour);
  for (const Ball& ball : drawing.balls) builder.capsule(ball.centre, ball.centre, ball.radius, ball.colour);
  for (const Ring& ring : drawing.rings) builder.ring(ring);
  for (const Sheet& sheet : drawing.sheets) builder.sheet(sheet);
  for (const Obstacle& obstacle : drawing.obstacles) {
    if (const auto* const ball = std::get_if<Sphere>(&obstacle.shape)) {
      builder.capsule(ball->centre, ball->centre, ball->radius, kSkin);
    } else if (const auto* const capsule = std::get_if<Capsule>(&obstacle.shape)) {
      builder.capsule(capsule->a, capsule->b, capsule->radius, kSkin);
    }
  }
  for (const PlacedMesh& placed : drawing.meshes) builder.placed(placed, kSkin);
  builder.mesh.casting = builder.mesh.indices.size();
  for (const Obstacle& obstacle : drawing.obstacles) {
    if (const auto* const plane = std::get_if<Plane>(&obstacle.shape)) builder.ground(*plane);
  }
  return std::move(builder.mesh);
}

}  // namespace hair
