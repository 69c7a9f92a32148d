#include "hair/scene/json/scalp.h"

#include <numbers>

#include "hair/head/bust.h"
#include "hair/head/root_sphere.h"
#include "hair/head/roots_between.h"
#include "hair/head/scalp_roots.h"
#include "hair/scene/json/values.h"
#include "hair/scene/roots.h"

namespace hair::json {

namespace {

std::vector<RootFrame> with_normal(const std::vector<Vector3d>& points, const Vector3d& normal) {
  std::vector<RootFrame> roots;
  for (const Vector3d& point : points) roots.push_back({point, normal, side_of(normal)});
  return roots;
}

std::vector<RootFrame> on_line(const JsonValue& line, int count) {
  return with_normal(points_on_line(vector(line["from"], kFar), vector(line["to"], kFar), count),
                     line.has("direction") ? direction(line["direction"]) : Vector3d(0, 0, -1));
}

std::vector<RootFrame> on_disc(const JsonValue& disc, int count) {
  const Vector3d normal = direction(disc["normal"]);
  return with_normal(points_on_disc(vector(disc["centre"], kFar), normal, length(disc["radius"]), count),
                     normal);
}

std::vector<RootFrame> on_cap(const JsonValue& cap, int count) {
  const Vector3d centre = vector(cap["centre"], kFar),
                 axis = cap.has("axis") ? direction(cap["axis"]) : Vector3d(0, 0, 1);
  const double radius = length(cap["radius"]),
               angle = number_or(cap, "degrees", 90, 0.1, 180) * std::numbers::pi / 180;
  std::vector<RootFrame> roots;
  for (const Vector3d& normal : directions_in_cap(axis, angle, count))
    roots.push_back({centre + radius * normal, normal, side_of(normal)});
  return roots;
}

std::vector<RootFrame> on_bust(const JsonValue& bust, int count, std::uint64_t seed) {
  const Vector3d at = vector_or(bust, "at", Vector3d::Zero(), kFar);
  std::vector<RootFrame> roots = scalp_roots(Bust(), count, seed);
  for (RootFrame& root : roots) root.position += at;
  return roots;
}

}  // namespace

GroupScalp scalp_of(const JsonValue& roots, int count) {
  if (roots.has("bust")) {
    const JsonValue bust = roots["bust"];
    const long seed = bust.has("seed") ? bust["seed"].whole_number(0, 1L << 53) : 0;
    return {on_bust(bust, count, static_cast<std::uint64_t>(seed)), true,
            [bust](int more, std::uint64_t own) { return on_bust(bust, more, own); }};
  }
  const auto any = [roots](int number, std::uint64_t) {
    if (roots.has("line")) return on_line(roots["line"], number);
    return roots.has("disc") ? on_disc(roots["disc"], number) : on_cap(roots["cap"], number);
  };
  return {any(count, 0), false, any};
}

GroupScalp scalp_of(const std::vector<RootFrame>& roots) {
  const std::vector<RootFrame> scalp = scalp_of_roots(roots);
  return {scalp, false, [scalp](int count, std::uint64_t seed) { return roots_between(scalp, count, seed); }};
}

}  // namespace hair::json
