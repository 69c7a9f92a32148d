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
  keys.vector("position", root.position, {.unit = "m", .needed = true});
  keys.direction("direction", root.direction, {}, "of any length");
}

void count_of(Keys& keys, int& count) {
  keys.whole("count", count, {.needed = true, .least = 1, .most = kMostParticles});
}

RootFrame frame_at(const Vector3d& position, const Vector3d& axis) {
  return {position, axis, side_of(axis)};
}

// Roots on a line, a disc or a cap. axis: the scalp's normal, or the direction in which hair leaves it.
std::vector<RootFrame> spread(const Roots& roots, int count, bool normals) {
  std::vector<RootFrame> frames;
  frames.reserve(static_cast<std::size_t>(count));
  if (const auto& line = roots.line)
    for (const Vector3d& point : points_on_line(line->from, line->to, count))
      frames.push_back(frame_at(point, line->direction));
  if (const auto& disc = roots.disc)
    for (const Vector3d& point : points_on_disc(disc->centre, disc->normal, disc->radius, count))
      frames.push_back(frame_at(point, normals ? disc->normal : disc->direction.value_or(disc->normal)));
  if (const auto& cap = roots.cap)
    for (const Vector3d& outward : directions_in_cap(cap->axis, cap->degrees * std::numbers::pi / 180, count))
      frames.push_back(frame_at(cap->centre + cap->radius * outward, outward));
  return frames;
}

}  // namespace

static void keys_of(Keys& keys, RootLine& line) {
  keys.vector("from", line.from, {.unit = "m", .needed = true});
  keys.vector("to", line.to, {.unit = "m", .needed = true});
  count_of(keys, line.count);
  keys.direction("direction", line.direction);
}

static void keys_of(Keys& keys, RootDisc& disc) {
  keys.vector("centre", disc.centre, {.unit = "m", .needed = true});
  keys.direction("normal", disc.normal, {.needed = true});
  keys.length("radius", disc.radius, {.needed = true});
  count_of(keys, disc.count);
  keys.direction("direction", disc.direction, {.otherwise = "the normal"});
}

static void keys_of(Keys& keys, RootCap& cap) {
  keys.about(
      "A part of a sphere. The cap is no obstacle: add a sphere under `obstacles` for the head. If that "
      "sphere is a little smaller than the cap, it does not push at the first segments.");
  keys.vector("centre", cap.centre, {.unit = "m", .needed = true}, "of the sphere");
  keys.length("radius", cap.radius, {.needed = true});
  count_of(keys, cap.count);
  keys.direction("axis", cap.axis, {}, "from the centre to the cap's middle");
  keys.number("degrees", cap.degrees, {.unit = "°", .least = 0.1, .most = 180},
              "from the axis to the cap's edge; 180 is the whole sphere");
}

void keys_of(Keys& keys, Roots& roots) {
  keys.one_of();
  keys.list("list", roots.list, {.objects = {object<ListedRoot>()}}, "one by one");
  keys.part("line", roots.line, {}, "in a row");
  keys.part("disc", roots.disc, {}, "in a tuft");
  keys.part("cap", roots.cap, {}, "on a head that is a sphere");
}

std::vector<RootFrame> make_roots(const JsonValue& object, const Roots& roots,
                                  const std::function<int(const JsonValue& where, long count)>& expect) {
  if (!roots.list) {
    const std::string kind = roots.line ? "line" : roots.disc ? "disc" : "cap";
    const int count = roots.line ? roots.line->count : roots.disc ? roots.disc->count : roots.cap->count;
    return spread(roots, expect(object[kind]["count"], count), false);
  }
  const std::vector<JsonValue> items = roots.list->items();
  if (items.empty()) roots.list->fail("has no roots; give one at least");
  expect(*roots.list, static_cast<long>(items.size()));
  std::vector<RootFrame> frames;
  for (const JsonValue& item : items) {
    const ListedRoot root = read<ListedRoot>(item);
    frames.push_back(frame_at(root.position, root.direction));
  }
  return frames;
}

GroupScalp scalp_of(const Roots& roots, int count) {
  return {spread(roots, count, true), false,
          [roots](int more, std::uint64_t) { return spread(roots, more, true); }};
}

GroupScalp scalp_of(const std::vector<RootFrame>& roots) {
  const std::vector<RootFrame> scalp = scalp_of_roots(roots);
  return {scalp, false, [scalp](int count, std::uint64_t seed) { return roots_between(scalp, count, seed); }};
}

}  // namespace hair::json
