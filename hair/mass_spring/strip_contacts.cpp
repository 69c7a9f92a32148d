#include "hair/mass_spring/strip_contacts.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace hair {

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
    : mesh_(mesh), first_(std::move(first)), boxes_(first_.size() - 1) {
  const auto particles = static_cast<std::size_t>(first_.back());
  contacts_.reserve(particles);
  sides_.reserve(particles);
  before_.reserve(particles);
}

void StripContacts::forget() {
  contacts_.clear();
  sides_.clear();
}

StripContacts::Box StripContacts::around(Input x, int particle) {
  const Eigen::Array3d at = x.segment<3>(3 * Eigen::Index{particle});
  return {at, at};
}

double StripContacts::side_of(int strip, int point, const std::array<int, 3>& triangle, Input x) const {
  const auto kept = std::lower_bound(
      before_.begin(), before_.end(), std::pair(strip, point),
      [](const Side& side, const auto& key) { return std::pair(side.strip, side.point) < key; });
  if (kept != before_.end() && kept->strip == strip && kept->point == point) return kept->side;
  const auto at = [&](int i) { return Vector3d(x.segment<3>(3 * Eigen::Index{i})); };
  const Vector3d corner = at(triangle[0]), area = (at(triangle[1]) - corner).cross(at(triangle[2]) - corner);
  return area.dot(at(point) - corner) < 0 ? -1 : 1;
}

void StripContacts::touch(int strip, int point, Input x, Input tangents) {
  const double thickness = mesh_.law.thickness;
  Box near = around(x, point);
  near.grow(thickness);
  StripContact contact;
  for (const std::array<int, 3>& triangle : mesh_.strips[strip].triangles) {
    Box box = around(x, triangle[0]);
    box.grow(around(x, triangle[1]));
    box.grow(around(x, triangle[2]));
    if (!box.meets(near)) continue;
    const double side = side_of(strip, point, triangle, x);
    if (!touch_strip(point, triangle, side, thickness, x, tangents, contact)) continue;
    contacts_.push_back(contact);
    sides_.push_back({strip, point, side});
    return;
  }
}

void StripContacts::touch_all(int strip, Input x, Input tangents) {
  const auto [one, other] = mesh_.strips[strip].guides;
  Box near = boxes_[one];
  near.grow(boxes_[other]);
  near.grow(mesh_.law.thickness);
  for (int g = 0; g < static_cast<int>(boxes_.size()); ++g) {
    if (g == one || g == other || !near.meets(boxes_[g])) continue;
    for (int i = first_[g] + 1; i < first_[g + 1]; ++i)
      if (near.meets(around(x, i))) touch(strip, i, x, tangents);
  }
}

void StripContacts::find(Input x, Input tangents) {
  for (std::size_t g = 0; g < boxes_.size(); ++g) {
    boxes_[g] = around(x, first_[g]);
    for (int i = first_[g]; i < first_[g + 1]; ++i) boxes_[g].grow(around(x, i));
  }
  std::swap(before_, sides_);
  forget();
  for (int strip = 0; strip < static_cast<int>(mesh_.strips.size()); ++strip) touch_all(strip, x, tangents);
}

}  // namespace hair
