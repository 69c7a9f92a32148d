#include "hair/linked_guides/strip_contacts.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace hair {
namespace {

Vector3d place(Input x, int particle) {
  return x.segment<3>(3 * Eigen::Index{particle});
}

// A particle and a triangle's corners.
struct Tetrahedron {
  Tetrahedron(Input x, int particle, const std::array<int, 3>& triangle)
      : point(place(x, particle)),
        corners{place(x, triangle[0]), place(x, triangle[1]), place(x, triangle[2])} {}

  Vector3d area() const { return (corners[1] - corners[0]).cross(corners[2] - corners[0]); }
  double height_times_area() const {
    return area().dot(point - corners[0]);
  }  // > 0 on the triangle's upper side

  // True if the point's projection lies in the triangle.
  bool is_over() const {
    for (int j = 0; j < 3; ++j) {
      const Vector3d& a = corners[j];
      if (area().dot((corners[(j + 1) % 3] - a).cross(point - a)) < 0) return false;
    }
    return true;
  }

  void go_back(double part, const Tetrahedron& before) {
    point += part * (before.point - point);
    for (int j = 0; j < 3; ++j) corners[j] += part * (before.corners[j] - corners[j]);
  }

  Vector3d point;
  std::array<Vector3d, 3> corners;
};

}  // namespace

void StripContacts::Box::grow(const Box& other) {
  low = low.min(other.low);
  high = high.max(other.high);
}

void StripContacts::Box::grow(double by) {
  low -= by;
  high += by;
}

bool StripContacts::Box::meets(const Box& other) const {
  return (low <= other.high).all() && (other.low <= high).all();
}

StripContacts::StripContacts(const ControlMesh& mesh, std::vector<int> first)
    : mesh_(mesh), first_(std::move(first)), boxes_(first_.size() - 1), passes_(boxes_.size()) {
  const auto particles = static_cast<std::size_t>(first_.back());
  contacts_.reserve(particles);
  sides_.reserve(particles);
  before_.reserve(particles);
  std::size_t triangles = 0;
  for (const MeshStrip& strip : mesh_.strips) triangles = std::max(triangles, strip.triangles.size());
  triangles_.reserve(triangles);
  last_.setZero(3 * static_cast<Eigen::Index>(particles));
}

void StripContacts::forget() {
  contacts_.clear();
  sides_.clear();
  moved_ = false;
  std::fill(passes_.begin(), passes_.end(), 0);
}

StripContacts::Box StripContacts::around(Input x, int particle) {
  const Eigen::Array3d at = x.segment<3>(3 * Eigen::Index{particle});
  return {at, at};
}

StripContacts::Box StripContacts::swept(Input x, int particle) const {
  Box box = around(x, particle);
  if (moved_) box.grow(around(last_, particle));
  return box;
}

double StripContacts::side_of(int strip, int point, const std::array<int, 3>& triangle, Input x) const {
  const auto kept = std::lower_bound(
      before_.begin(), before_.end(), std::pair(strip, point),
      [](const Side& side, const auto& key) { return std::pair(side.strip, side.point) < key; });
  if (kept != before_.end() && kept->strip == strip && kept->point == point) return kept->side;
  const Tetrahedron from = moved_ ? Tetrahedron(last_, point, triangle) : Tetrahedron(x, point, triangle);
  return from.height_times_area() < 0 ? -1 : 1;
}

// Checks a particle that belonged to `side` and does not touch now. The time at which it crossed the
// triangle's plane is found as if its height had changed linearly.
bool StripContacts::passed(int point, const std::array<int, 3>& triangle, double side, Input x) const {
  Tetrahedron now(x, point, triangle);
  const double height = side * now.height_times_area();
  if (!moved_ || height >= 0) return false;
  const Tetrahedron before(last_, point, triangle);
  const double height_before = side * before.height_times_area();
  if (height_before >= 0) now.go_back(height / (height - height_before), before);
  return now.is_over();
}

void StripContacts::touch(int strip, int guide, int point, Input x, Input tangents) {
  const double thickness = mesh_.law.thickness;
  const Box near = swept(x, point);
  StripContact contact;
  bool through = false;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    if (!triangles_[t].meets(near)) continue;
    const std::array<int, 3>& triangle = mesh_.strips[strip].triangles[t];
    const double side = side_of(strip, point, triangle, x);
    if (touch_strip(point, triangle, side, thickness, x, tangents, contact)) {
      contacts_.push_back(contact);
      sides_.push_back({strip, point, side});
      return;
    }
    through = through || passed(point, triangle, side, x);
  }
  if (through) ++passes_[static_cast<std::size_t>(guide)];
}

void StripContacts::touch_all(int strip, Input x, Input tangents) {
  const auto [one, other] = mesh_.strips[strip].guides;
  Box near = boxes_[one];
  near.grow(boxes_[other]);
  near.grow(mesh_.law.thickness);
  triangles_.clear();
  for (const auto& [a, b, c] : mesh_.strips[strip].triangles) {
    Box& box = triangles_.emplace_back(swept(x, a));
    box.grow(swept(x, b));
    box.grow(swept(x, c));
    box.grow(mesh_.law.thickness);
  }
  for (int g = 0; g < static_cast<int>(boxes_.size()); ++g) {
    if (g == one || g == other || !near.meets(boxes_[g])) continue;
    for (int i = first_[g] + 1; i < first_[g + 1]; ++i)
      if (near.meets(swept(x, i))) touch(strip, g, i, x, tangents);
  }
}

void StripContacts::find(Input x, Input tangents) {
  for (std::size_t g = 0; g < boxes_.size(); ++g) {
    boxes_[g] = swept(x, first_[g]);
    for (int i = first_[g]; i < first_[g + 1]; ++i) boxes_[g].grow(swept(x, i));
  }
  std::swap(before_, sides_);
  contacts_.clear();
  sides_.clear();
  for (int strip = 0; strip < static_cast<int>(mesh_.strips.size()); ++strip) touch_all(strip, x, tangents);
  last_ = x;
  moved_ = true;
}

}  // namespace hair
