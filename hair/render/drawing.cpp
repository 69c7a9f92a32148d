#include "hair/render/drawing.h"

#include <numeric>
#include <string>

#include "particles/require.h"

namespace hair {
namespace {

using particles::require;

void check_points(const std::vector<Vector3d>& points, const std::string& what) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!points[i].allFinite())
      require(false, "the norm of point " + std::to_string(i) + " of " + what, points[i].norm(), "finite");
}

}  // namespace

void check_drawing(const Drawing& drawing) {
  const StrandsDrawing& strands = drawing.strands;
  for (std::size_t i = 0; i < strands.sizes.size(); ++i)
    require(strands.sizes[i] >= 1, "the number of points of strand " + std::to_string(i), strands.sizes[i],
            "at least 1");
  const auto points = std::accumulate(strands.sizes.begin(), strands.sizes.end(), std::size_t{0});
  require(points == strands.points.size(), "the number of strands' points",
          static_cast<double>(strands.points.size()), std::to_string(points) + ", the sum of their sizes");
  check_points(strands.points, "the strands");
  for (const Tube& tube : drawing.tubes) check_points({tube.a, tube.b}, "a tube");
  for (const Ball& ball : drawing.balls) check_points({ball.centre}, "a ball");
  for (const Ring& ring : drawing.rings) check_points({ring.centre, ring.normal}, "a ring");
  for (const Sheet& sheet : drawing.sheets) {
    require(static_cast<double>(sheet.rows) * sheet.columns == static_cast<double>(sheet.points.size()),
            "the number of a sheet's points", static_cast<double>(sheet.points.size()),
            "its rows times its columns");
    check_points(sheet.points, "a sheet");
  }
  for (const PlacedMesh& placed : drawing.meshes) check_points({placed.at}, "a mesh's place");
  for (const Obstacle& obstacle : drawing.obstacles) check_obstacle(obstacle);
}

}  // namespace hair
