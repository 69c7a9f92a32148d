// The content of a picture, as plain data: the renderer is independent of scenes, simulations and exercises.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "hair/head/surface_net.h"
#include "hair/obstacles/obstacles.h"

namespace hair {

using Colour = Eigen::Vector3f;  // linear, 0 to 1

// Strands, one after the other; each is a line through its points.
struct StrandsDrawing {
  std::vector<int> sizes;        // points of each strand, >= 1
  std::vector<Vector3d> points;  // m, strand after strand
  double width = 1e-4;           // m, of a strand
  Colour root = {0.10f, 0.05f, 0.02f}, tip = {0.22f, 0.12f, 0.05f};
  // Draws fine hair: as thin as it is, with tapered tips and varied colours (hair_layer.h). Otherwise draws
  // ribbons, which are never thinner than half a pixel.
  bool fine = false;
  // For fine hair: a number for each strand, the same in all pictures; empty: its index among the strands.
  std::vector<std::uint32_t> ids = {};

  std::uint32_t id(std::size_t strand) const {
    return ids.empty() ? static_cast<std::uint32_t>(strand) : ids[strand];
  }
};

// The parts of toys: rods and springs between points, wires, and cloth.
struct Tube {
  Vector3d a, b;  // m
  double radius;  // m
  Colour colour;
};

struct Ball {
  Vector3d centre;
  double radius;
  Colour colour;
};

struct Ring {
  Vector3d centre, normal;
  double radius, thickness;
  Colour colour;
};

// A grid of rows x columns points, visible from both sides.
struct Sheet {
  int rows, columns;
  std::vector<Vector3d> points;
  Colour colour;
};

// A solid's surface, turned about its origin and moved to `at`.
struct PlacedMesh {
  std::shared_ptr<const SurfaceMesh> mesh;
  Vector3d at;  // m
  Eigen::Quaterniond rotation;
};

struct Drawing {
  StrandsDrawing strands;
  std::vector<Tube> tubes;
  std::vector<Ball> balls;
  std::vector<Ring> rings;
  std::vector<Sheet> sheets;
  std::vector<Obstacle>
      obstacles;  // ground, balls, limbs, at their present positions; solids are drawn as meshes
  std::vector<PlacedMesh> meshes;
};

// Throws std::invalid_argument with the reason, before OpenGL sees it: a place that is not finite, such as a
// strand of H10 may have, or sizes that don't match their points.
void check_drawing(const Drawing& drawing);

}  // namespace hair
