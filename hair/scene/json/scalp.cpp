#include "hair/scene/json/scalp.h"

#include "hair/dense/roots_between.h"
#include "hair/groom/root_sphere.h"
#include "hair/scene/roots.h"

namespace hair::json {

namespace {

std::vector<RootFrame> with_normal(const std::vector<Vector3d>& points, const Vector3d& normal) {
  std::vector<RootFrame> roots;
  for (const Vector3d& point : points) roots.push_back({point, normal, side_of(normal)});
  return roots;
}

std::vector<RootFrame> along(const Roots& roots, int count) {
  if (const auto& line = roots.line)
    return with_normal(points_on_line(line->from, line->to, count), line->direction);
  if (const auto& disc = roots.disc)
    return with_normal(points_on_disc(disc->centre, disc->normal, disc->radius, count), disc->normal);
  return on_cap(*roots.cap, count);
}

}  // namespace

GroupScalp scalp_of(const Roots& roots, int count) {
  return {along(roots, count), false, [roots](int more, std::uint64_t) { return along(roots, more); }};
}

GroupScalp scalp_of(const std::vector<RootFrame>& roots) {
  const std::vector<RootFrame> scalp = scalp_of_roots(roots);
  return {scalp, false, [scalp](int count, std::uint64_t seed) { return roots_between(scalp, count, seed); }};
}

}  // namespace hair::json
