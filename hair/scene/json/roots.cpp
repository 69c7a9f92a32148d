#include "hair/scene/json/roots.h"

#include <numbers>

#include "hair/dense/roots_between.h"
#include "hair/groom/root_sphere.h"
#include "hair/scene/json/parts.h"
#include "hair/scene/roots.h"

namespace hair::json {

namespace {

struct ListedRoot {
  Vector3d position, direction = {0, 0, -1};
};

void keys_of(Keys& keys, ListedRoot& root) {
  keys.vector({.name = "position", .unit = "m", .needed = true}, root.position);
  keys.direction({.name = "direction", .what = "of any length"}, root.direction);
}

void count_of(Keys& keys, int& count) {
  keys.whole({.name = "count", .needed = true, .least = 1, .most = kMostParticles}, count);
}

RootFrame frame_at(const Vector3d& position, const Vector3d& axis) {
  return {position, axis, side_of(axis)};
}

std::vector<RootFrame> all_along(const std::vector<Vector3d>& points, const Vector3d& axis) {
  std::vector<RootFrame> frames;
  frames.reserve(points.size());
  for (const Vector3d& point : points) frames.push_back(frame_at(point, axis));
  return frames;
}

std::vector<RootFrame> listed(const std::vector<JsonValue>& items) {
  std::vector<RootFrame> frames;
  for (const JsonValue& item : items) {
    const ListedRoot root = read<ListedRoot>(item);
    frames.push_back(frame_at(root.position, root.direction));
  }
  return frames;
}

}  // namespace

std::vector<RootFrame> on_cap(const RootCap& cap, int count) {
  std::vector<RootFrame> frames;
  frames.reserve(static_cast<std::size_t>(count));
  for (const Vector3d& outward : directions_in_cap(cap.axis, cap.degrees * std::numbers::pi / 180, count))
    frames.push_back(frame_at(cap.centre + cap.radius * outward, outward));
  return frames;
}

static void keys_of(Keys& keys, RootLine& line) {
  keys.vector({.name = "from", .unit = "m", .needed = true}, line.from);
  keys.vector({.name = "to", .unit = "m", .needed = true}, line.to);
  count_of(keys, line.count);
  keys.direction({.name = "direction"}, line.direction);
}

static void keys_of(Keys& keys, RootDisc& disc) {
  keys.vector({.name = "centre", .unit = "m", .needed = true}, disc.centre);
  keys.direction({.name = "normal", .needed = true}, disc.normal);
  keys.number(a_length({.name = "radius", .needed = true}), disc.radius);
  count_of(keys, disc.count);
  keys.direction({.name = "direction", .otherwise = "the normal"}, disc.direction);
}

static void keys_of(Keys& keys, RootCap& cap) {
  keys.about(
      "A part of a sphere. The cap is no obstacle: add a sphere under `obstacles` for the head. If that "
      "sphere is a little smaller than the cap, it does not push at the first segments.");
  keys.vector({.name = "centre", .unit = "m", .needed = true, .what = "of the sphere"}, cap.centre);
  keys.number(a_length({.name = "radius", .needed = true}), cap.radius);
  count_of(keys, cap.count);
  keys.direction({.name = "axis", .what = "from the centre to the cap's middle"}, cap.axis);
  keys.number({.name = "degrees",
               .unit = "°",
               .least = 0.1,
               .most = 180,
               .what = "from the axis to the cap's edge; 180 is the whole sphere"},
              cap.degrees);
}

void keys_of(Keys& keys, Roots& roots) {
  keys.one_of();
  keys.list({.name = "list", .what = "one by one"}, roots.list, {object<ListedRoot>()});
  keys.part({.name = "line", .what = "in a row"}, roots.line);
  keys.part({.name = "disc", .what = "in a tuft"}, roots.disc);
  keys.part({.name = "cap", .what = "on a head that is a sphere"}, roots.cap);
}

std::vector<RootFrame> make_roots(const JsonValue& object, const Roots& roots,
                                  const std::function<int(const JsonValue& where, long count)>& expect) {
  if (roots.list) {
    const std::vector<JsonValue> items = roots.list->items();
    if (items.empty()) roots.list->fail("has no roots; give one at least");
    expect(*roots.list, static_cast<long>(items.size()));
    return listed(items);
  }
  const auto expect_count = [&](const char* kind, int count) { return expect(object[kind]["count"], count); };
  if (const auto& line = roots.line) {
    const int made = expect_count("line", line->count);
    return all_along(points_on_line(line->from, line->to, made), line->direction);
  }
  if (const auto& disc = roots.disc) {
    const int made = expect_count("disc", disc->count);
    return all_along(points_on_disc(disc->centre, disc->normal, disc->radius, made),
                     disc->direction.value_or(disc->normal));
  }
  return on_cap(*roots.cap, expect_count("cap", roots.cap->count));
}

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
