// The Delaunay triangulation of points in the plane: no point lies inside the circle through the corners of a
// triangle. Points are added one by one, and triangles whose circle holds the new point are replaced: A.
// Bowyer, "Computing Dirichlet tessellations", and D. F. Watson, "Computing the n-dimensional Delaunay
// tessellation" (The Computer Journal 24, 1981).
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace hair {

using Eigen::Vector2d;

struct Triangulation {
  struct Triangle {
    std::array<int, 3> corners;     // counter-clockwise
    std::array<int, 3> neighbours;  // neighbours[k] is opposite to corners[k]; -1: none
  };
  std::vector<Vector2d> points;
  std::vector<Triangle> triangles;

  // The triangle that holds `at`. If `at` is outside, one at the edge of the triangulation on the way from
  // triangle `from`.
  int triangle_at(const Vector2d& at, int from = 0) const;
};

// Points on one line, and fewer than three, have no triangles. Points may coincide. For four points on a
// circle, a fixed random choice decides: all points are first moved by up to a millionth of their width.
Triangulation triangulate(const std::vector<Vector2d>& points);

}  // namespace hair
