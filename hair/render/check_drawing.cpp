#include "hair/render/check_drawing.h"

#include <stdexcept>
#include <string>

#include "particles/require.h"

namespace hair {
namespace {

using particles::require;

void check_points(const std::vector<Vector3d>& points, const std::string& what) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) {
      require(false, "the norm of point " + std::to_string(i) + " of " + what, points[i].norm(), "finite");
    }
  }
}

void check_colour(const Colour& colour, const std::string& what) {
  require((colour.array() >= 0).all() && (colour.array() <= 1).all(), "the colour of " + what, colour.norm(),
          "of numbers from 0 to 1");
}

}  // namespace

void check_drawing(const Drawing& drawing) {
  const StrandsDrawing& strands = drawing.strands;
  std::size_t points = 0;
  for (std::size_t i = 0; i < strands.sizes.size(); ++i) {
    const int size = strands.sizes[i];
    require(size >= 1, "the number of points of strand " + std::to_string(i), size, "at least 1");
    points += static_cast<std::size_t>(size);
    require(points <= kMostStrandPoints, "the number of all strands' points", static_cast<double>(points),
            "at most 20 million");
  }
  require(points == strands.points.size(), "the number of strands' points",
          static_cast<double>(strands.points.size()), std::to_string(points) + ", the sum of their sizes");
  check_points(strands.points, "the strands");
  if (!strands.sizes.empty()) {
    particles::require_positive("the width of strands", strands.width);
    check_colour(strands.root, "roots");
    check_colour(strands.tip, "tips");
  }
  const std::size_t round = drawing.tubes.size() + drawing.balls.size() + drawing.rings.size();
  require(round <= kMostRound, "the number of tubes, balls and rings", static_cast<double>(round),
          "at most 100000");
  for (const Tube& tube : drawing.tubes) {
    check_points({tube.a, tube.b}, "a tube");
    particles::require_positive("the radius of a tube", tube.radius);
    check_colour(tube.colour, "a tube");
  }
  for (const Ball& ball : drawing.balls) {
    check_points({ball.centre}, "a ball");
    particles::require_positive("the radius of a ball", ball.radius);
    check_colour(ball.colour, "a ball");
  }
  for (const Ring& ring : drawing.rings) {
    check_points({ring.centre, ring.normal}, "a ring");
    particles::require_positive("the length of a ring's normal", ring.normal.norm());
    particles::require_positive("the radius of a ring", ring.radius);
    particles::require_positive("the thickness of a ring", ring.thickness);
    check_colour(ring.colour, "a ring");
  }
  for (const Sheet& sheet : drawing.sheets) {
    require(sheet.rows >= 2 && sheet.columns >= 2, "the rows or columns of a sheet",
            sheet.rows < sheet.columns ? sheet.rows : sheet.columns, "at least 2");
    const auto size = static_cast<double>(sheet.rows) * sheet.columns;
    require(size <= 1e6, "the number of a sheet's points", size, "at most a million");
    require(size == static_cast<double>(sheet.points.size()), "the number of a sheet's points",
            static_cast<double>(sheet.points.size()), "its rows times its columns");
    check_points(sheet.points, "a sheet");
    check_colour(sheet.colour, "a sheet");
  }
  for (const PlacedMesh& placed : drawing.meshes) {
    if (!placed.mesh) throw std::invalid_argument("a placed mesh without a mesh; give one");
    require(placed.mesh->points.size() == placed.mesh->normals.size(), "the number of a mesh's normals",
            static_cast<double>(placed.mesh->normals.size()), "that of its points");
    check_points(placed.mesh->points, "a mesh");
    check_points({placed.at}, "a mesh's place");
    const double norm = placed.rotation.norm();
    require(norm >= 1 - 1e-9 && norm <= 1 + 1e-9, "the length of a mesh's rotation", norm, "1");
    for (const auto& triangle : placed.mesh->triangles)
      for (const std::uint32_t corner : triangle)
        require(corner < placed.mesh->points.size(), "a corner of a mesh's triangle", corner,
                "less than the number of its points");
  }
  for (const Obstacle& obstacle : drawing.obstacles) check_obstacle(obstacle);
}

}  // namespace hair
