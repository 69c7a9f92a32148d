#include "hair/dense/triangulation.h"

#include <algorithm>
#include <utility>

#include "hair/strand/variation.h"

namespace hair {
namespace {

using Triangle = Triangulation::Triangle;

constexpr double kMoved = 1e-6, kFarCorner = 1000;  // times the width of all points

double twice_area(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool circle_holds(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& p) {
  const Vector2d u = a - p, v = b - p, w = c - p;
  return u.squaredNorm() * (v.x() * w.y() - v.y() * w.x()) -
             v.squaredNorm() * (u.x() * w.y() - u.y() * w.x()) +
             w.squaredNorm() * (u.x() * v.y() - u.y() * v.x()) >
         0;
}

// Adds points within a triangle that is far larger than all of them.
class DelaunayBuilder {
 public:
  explicit DelaunayBuilder(const std::vector<Vector2d>& points, const Vector2d& middle, double width) {
    all_.points = points;
    const int first = static_cast<int>(points.size());
    all_.points.emplace_back(middle + kFarCorner * width * Vector2d(-1, -1));
    all_.points.emplace_back(middle + kFarCorner * width * Vector2d(1, -1));
    all_.points.emplace_back(middle + kFarCorner * width * Vector2d(0, 1));
    all_.triangles.push_back({{first, first + 1, first + 2}, {-1, -1, -1}});
  }

  void add(int point) {
    find_hole(point);
    fill_hole(point);
  }

  // The result without the large triangle, and all triangles at its corners.
  Triangulation take(int points) {
    std::vector<int> index(all_.triangles.size(), -1);
    Triangulation kept;
    for (std::size_t i = 0; i < all_.triangles.size(); ++i) {
      const std::array<int, 3>& corners = all_.triangles[i].corners;
      if (*std::max_element(corners.begin(), corners.end()) >= points) continue;
      index[i] = static_cast<int>(kept.triangles.size());
      kept.triangles.push_back(all_.triangles[i]);
    }
    for (Triangle& triangle : kept.triangles)
      for (int& neighbour : triangle.neighbours) neighbour = neighbour < 0 ? -1 : index[neighbour];
    all_.points.resize(static_cast<std::size_t>(points));
    kept.points = std::move(all_.points);
    return kept;
  }

 private:
  struct Edge {
    int from, to, outside;  // counter-clockwise around the hole
  };

  bool sees(int triangle, int point) const {
    const std::array<int, 3>& corners = all_.triangles[triangle].corners;
    return circle_holds(all_.points[corners[0]], all_.points[corners[1]], all_.points[corners[2]],
                        all_.points[point]);
  }

  // The triangles whose circles hold the point, and the edges around them.
  void find_hole(int point) {
    hole_.assign(1, all_.triangle_at(all_.points[point], last_));
    rim_.clear();
    for (std::size_t i = 0; i < hole_.size(); ++i) {
      const Triangle triangle = all_.triangles[hole_[i]];
      for (int k = 0; k < 3; ++k) {
        const int next = triangle.neighbours[k];
        if (std::find(hole_.begin(), hole_.end(), next) != hole_.end()) continue;
        if (next >= 0 && sees(next, point))
          hole_.push_back(next);
        else
          rim_.push_back({triangle.corners[(k + 1) % 3], triangle.corners[(k + 2) % 3], next});
      }
    }
    // An edge between two triangles of the hole may have been added before the second one was found.
    std::erase_if(rim_, [this](const Edge& edge) {
      return std::find(hole_.begin(), hole_.end(), edge.outside) != hole_.end();
    });
  }

  // Makes a triangle from each edge of the rim to the point, and replaces the hole's triangles.
  void fill_hole(int point) {
    std::vector<int>& made = hole_;
    while (made.size() < rim_.size()) {
      made.push_back(static_cast<int>(all_.triangles.size()));
      all_.triangles.emplace_back();
    }
    for (std::size_t i = 0; i < rim_.size(); ++i) {
      const Edge& edge = rim_[i];
      Triangle& triangle = all_.triangles[made[i]];
      triangle.corners = {edge.from, edge.to, point};
      const auto beside = [&](const auto& meets) {
        const auto found = std::find_if(rim_.begin(), rim_.end(), meets);
        return made[static_cast<std::size_t>(found - rim_.begin())];
      };
      triangle.neighbours = {beside([&](const Edge& other) { return other.from == edge.to; }),
                             beside([&](const Edge& other) { return other.to == edge.from; }), edge.outside};
      if (edge.outside < 0) continue;
      Triangle& outside = all_.triangles[edge.outside];
      for (int k = 0; k < 3; ++k)
        if (outside.corners[k] != edge.from && outside.corners[k] != edge.to) outside.neighbours[k] = made[i];
    }
    last_ = made.front();
  }

  Triangulation all_;
  std::vector<int> hole_;
  std::vector<Edge> rim_;
  int last_ = 0;
};

}  // namespace

int Triangulation::triangle_at(const Vector2d& at, int from) const {
  // The search comes nearer with each triangle; the count ends it if rounding makes it alternate.
  for (std::size_t steps = 0; steps <= triangles.size(); ++steps) {
    const Triangle& triangle = triangles[from];
    int next = -1;
    for (int k = 0; k < 3 && next < 0; ++k)
      if (twice_area(points[triangle.corners[(k + 1) % 3]], points[triangle.corners[(k + 2) % 3]], at) < 0)
        next = triangle.neighbours[k];
    if (next < 0) break;
    from = next;
  }
  return from;
}

Triangulation triangulate(const std::vector<Vector2d>& points) {
  const int count = static_cast<int>(points.size());
  if (count < 3) return {points, {}};
  Vector2d low = points.front(), high = points.front();
  for (const Vector2d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const double width = (high - low).maxCoeff();
  if (!(width > 0)) return {points, {}};
  std::vector<Vector2d> moved = points;
  Variation variation(0);
  for (Vector2d& point : moved) {
    const double x = variation.uniform(-0.5, 0.5), y = variation.uniform(-0.5, 0.5);
    point += kMoved * width * Vector2d(x, y);
  }
  DelaunayBuilder builder(moved, (low + high) / 2, width);
  for (int i = 0; i < count; ++i) builder.add(i);
  Triangulation found = builder.take(count);
  found.points = points;
  // A triangulation whose width comes only from the random moves: its points are on a line.
  const auto flat = [&](const Triangle& triangle) {
    return twice_area(moved[triangle.corners[0]], moved[triangle.corners[1]], moved[triangle.corners[2]]) <
           4 * kMoved * width * width;
  };
  if (std::all_of(found.triangles.begin(), found.triangles.end(), flat)) found.triangles.clear();
  return found;
}

}  // namespace hair
