// A solid's surface as triangles, for pictures: a surface net. S. F. F. Gibson, "Constrained Elastic Surface
// Nets" (MICCAI 1998): space is divided into cubes, each cube has a vertex for each sheet of the surface in
// it, and each edge of the grid that goes through the surface has a quadrilateral between the vertices of its
// four cubes. Here vertices go on to the surface by steps of Newton's method, instead of being relaxed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hair/obstacles/solid.h"

namespace hair {

struct SurfaceMesh {
  std::vector<Vector3d> points, normals;                // m, and the solid's normals there
  std::vector<std::array<std::uint32_t, 3>> triangles;  // anticlockwise, as seen from outside
};

// The box is divided into cubes, `cells` of them along its longest side. The mesh is closed, and it is a
// manifold if the solid is thicker than two cubes. The same solid and cells give the same mesh. Throws
// std::invalid_argument for fewer than 4 and more than 1000 cells.
SurfaceMesh surface_net(const Solid& solid, int cells);

}  // namespace hair
