#include "hair/head/surface_net.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace hair {

namespace {

using Lattice = Eigen::Vector3i;

// The distances at the corners of a grid that goes beyond a solid's box on all sides.
class CornerGrid {
 public:
  CornerGrid(const Solid& solid, int cells) : solid_(solid) {
    const Eigen::AlignedBox3d box = solid.box();
    width_ = box.sizes().maxCoeff() / cells;
    corners_ = (box.sizes() / width_).array().ceil().cast<int>() + 3;
    // The grid avoids round numbers, so that no corner of a symmetrical solid is on its surface by chance.
    first_ = box.center() -
             0.5 * width_ * ((corners_.array() - 1).cast<double>().matrix() + Vector3d(0.017, 0.029, 0.041));
    distances_.assign(static_cast<std::size_t>(corners_.cast<long>().prod()), 0);
    fill();
  }

  double width() const { return width_; }
  const Lattice& corners() const { return corners_; }
  Vector3d point(const Lattice& at) const { return first_ + width_ * at.cast<double>(); }
  std::size_t index(const Lattice& at) const {
    return static_cast<std::size_t>((static_cast<long>(at.z()) * corners_.y() + at.y()) * corners_.x() +
                                    at.x());
  }
  double distance(const Lattice& at) const { return distances_[index(at)]; }

  template <class Visit>
  void for_each(const Lattice& until, int step, const Visit& visit) const {
    Lattice at;
    for (at.z() = 0; at.z() < until.z(); at.z() += step)
      for (at.y() = 0; at.y() < until.y(); at.y() += step)
        for (at.x() = 0; at.x() < until.x(); at.x() += step) visit(at);
  }

 private:
  // A block that is wholly inside or outside needs only the distance at its middle.
  void fill() {
    constexpr int block = 4;
    for_each(corners_, block, [&](const Lattice& low) {
      const Lattice high = (low.array() + block).min(corners_.array());
      const Vector3d middle = 0.5 * (point(low) + point(high - Lattice::Ones()));
      const double whole = solid_.surface_at(middle).distance;
      const double reach = 0.5 * block * width_ * std::sqrt(3.0);
      const bool far = std::abs(whole) > 3 * reach;
      for_each(high - low, 1, [&](const Lattice& in) {
        distances_[index(low + in)] = far ? whole : solid_.surface_at(point(low + in)).distance;
      });
    });
  }

  const Solid& solid_;
  double width_;
  Lattice corners_;
  Vector3d first_;
  std::vector<double> distances_;
};

// An edge of a cube goes along an axis. Around this axis, the cube's four edges are at 0 or 1 of the two
// other axes.
constexpr int edge_number(int axis, int u, int v) {
  return 4 * axis + u + 2 * v;
}

// The sheets of the surface in one cube: crossings of edges belong to one sheet if faces join them. If a face
// has four, each pair around an inner corner is joined, and both cubes of the face decide alike.
class Sheets {
 public:
  Sheets(const CornerGrid& grid, const Lattice& cube) : grid_(grid), cube_(cube) {
    bool any_inside = false, any_outside = false;
    for (int corner = 0; corner < 8; ++corner) (is_inside(corner) ? any_inside : any_outside) = true;
    crossed_ = any_inside && any_outside;
    if (!crossed_) return;
    for (int edge = 0; edge < 12; ++edge) sheet_[static_cast<std::size_t>(edge)] = edge;
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) join_face(axis, side);
  }

  bool crossed() const { return crossed_; }

  // The first edge of an edge's sheet, for each edge that crosses the surface; -1 for others.
  int sheet_of(int edge) const {
    const auto [from, to] = ends(edge);
    return is_inside(from) == is_inside(to) ? -1 : sheet_[static_cast<std::size_t>(edge)];
  }

  Vector3d crossing(int edge) const {
    const auto [from, to] = ends(edge);
    const double a = distance(from), b = distance(to);
    return grid_.point(place(from)) + a / (a - b) * (grid_.point(place(to)) - grid_.point(place(from)));
  }

 private:
  // The bits of a corner's number are its places along the axes.
  Lattice place(int corner) const { return cube_ + Lattice(corner & 1, corner >> 1 & 1, corner >> 2 & 1); }
  double distance(int corner) const { return grid_.distance(place(corner)); }
  bool is_inside(int corner) const { return distance(corner) < 0; }

  static std::pair<int, int> ends(int edge) {
    const int axis = edge / 4, u = (axis + 1) % 3, v = (axis + 2) % 3;
    const int from = (edge & 1) << u | (edge >> 1 & 1) << v;
    return {from, from | 1 << axis};
  }

  void join(int a, int b) {
    const int from = std::max(sheet_[static_cast<std::size_t>(a)], sheet_[static_cast<std::size_t>(b)]);
    const int to = std::min(sheet_[static_cast<std::size_t>(a)], sheet_[static_cast<std::size_t>(b)]);
    std::replace(sheet_.begin(), sheet_.end(), from, to);
  }

  // The face at `side` of the axis n; its edges go along u and v.
  void join_face(int n, int side) {
    const int u = (n + 1) % 3, v = (n + 2) % 3;
    // edge_number expects the other axes in cyclic order: v, n after u, and n, u after v.
    const auto along_u = [&](int at_v) { return edge_number(u, at_v, side); };
    const auto along_v = [&](int at_u) { return edge_number(v, side, at_u); };
    const std::array<int, 4> edges = {along_u(0), along_u(1), along_v(0), along_v(1)};
    std::array<int, 4> crossed{};
    std::size_t count = 0;
    for (const int edge : edges)
      if (sheet_of(edge) >= 0) crossed[count++] = edge;
    if (count == 2) join(crossed[0], crossed[1]);
    if (count < 4) return;
    for (int at_u = 0; at_u < 2; ++at_u)
      for (int at_v = 0; at_v < 2; ++at_v)
        if (is_inside(side << n | at_u << u | at_v << v)) join(along_u(at_v), along_v(at_u));
  }

  const CornerGrid& grid_;
  Lattice cube_;
  bool crossed_ = false;
  std::array<int, 12> sheet_{};
};

Vector3d on_surface(const Solid& solid, Vector3d point) {
  for (int i = 0; i < 30; ++i) {
    const auto [distance, normal] = solid.surface_at(point);
    point -= distance * normal;
    if (std::abs(distance) < 1e-9) break;
  }
  return point;
}

}  // namespace

SurfaceMesh surface_net(const Solid& solid, int cells) {
  if (cells < 4 || cells > 1000)
    throw std::invalid_argument("a surface net of " + std::to_string(cells) + " cells; 4 to 1000 are right");
  const CornerGrid grid(solid, cells);
  SurfaceMesh mesh;
  // For each cube that the surface crosses, in order: the vertex at each of its edges.
  constexpr std::uint32_t none = 0xffffffff;
  std::vector<std::uint32_t> number(static_cast<std::size_t>(grid.corners().cast<long>().prod()), none);
  std::vector<std::array<std::uint32_t, 12>> vertices;
  grid.for_each(grid.corners() - Lattice::Ones(), 1, [&](const Lattice& cube) {
    const Sheets sheets(grid, cube);
    if (!sheets.crossed()) return;
    number[grid.index(cube)] = static_cast<std::uint32_t>(vertices.size());
    std::array<std::uint32_t, 12>& at_edges = vertices.emplace_back();
    at_edges.fill(none);
    for (int first = 0; first < 12; ++first) {
      if (sheets.sheet_of(first) != first) continue;
      Vector3d mean = Vector3d::Zero();
      int crossings = 0;
      for (int edge = first; edge < 12; ++edge) {
        if (sheets.sheet_of(edge) != first) continue;
        mean += sheets.crossing(edge);
        ++crossings;
        at_edges[static_cast<std::size_t>(edge)] = static_cast<std::uint32_t>(mesh.points.size());
      }
      mesh.points.push_back(on_surface(solid, mean / crossings));
      mesh.normals.push_back(solid.surface_at(mesh.points.back()).normal);
    }
  });
  grid.for_each(grid.corners() - Lattice::Ones(), 1, [&](const Lattice& from) {
    for (int axis = 0; axis < 3; ++axis) {
      const bool enters = grid.distance(from) >= 0;
      if (enters == (grid.distance(from + Lattice::Unit(axis)) >= 0)) continue;
      const Lattice u = Lattice::Unit((axis + 1) % 3), v = Lattice::Unit((axis + 2) % 3);
      const auto vertex = [&](const Lattice& cube, int at_u, int at_v) {
        return vertices[number[grid.index(cube)]][static_cast<std::size_t>(edge_number(axis, at_u, at_v))];
      };
      // Around the edge, anticlockwise when one looks against the axis.
      std::array<std::uint32_t, 4> around = {vertex(from - u - v, 1, 1), vertex(from - v, 0, 1),
                                             vertex(from, 0, 0), vertex(from - u, 1, 0)};
      if (enters) std::swap(around[1], around[3]);
      const auto apart = [&](std::size_t i, std::size_t k) {
        return (mesh.points[around[i]] - mesh.points[around[k]]).squaredNorm();
      };
      // The quadrilateral is split along its shorter diagonal.
      const std::size_t first = apart(0, 2) <= apart(1, 3) ? 0 : 1;
      for (const std::size_t k : {first, first + 2})
        mesh.triangles.push_back({around[k], around[(k + 1) % 4], around[(k + 2) % 4]});
    }
  });
  return mesh;
}

}  // namespace hair
