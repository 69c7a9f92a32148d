#include "hair/scene/json/roots.h"

#include <numbers>

#include "hair/head/bust.h"
#include "hair/head/scalp_roots.h"
#include "hair/scene/json/parts.h"
#include "hair/scene/json/values.h"
#include "hair/scene/roots.h"

namespace hair::json {

namespace {

using Expect = std::function<void(const JsonValue&, long)>;

RootFrame frame_at(const Vector3d& position, const Vector3d& axis) {
  return {position, axis, side_of(axis)};
}

int read_count(const JsonValue& value, const Expect& expect) {
  const long count = value.whole_number(1, kMostParticles);
  expect(value, count);
  return static_cast<int>(count);
}

std::vector<RootFrame> all_along(const std::vector<Vector3d>& points, const Vector3d& axis) {
  std::vector<RootFrame> frames;
  frames.reserve(points.size());
  for (const Vector3d& point : points) frames.push_back(frame_at(point, axis));
  return frames;
}

std::vector<RootFrame> read_list(const JsonValue& list, const Expect& expect) {
  const std::vector<JsonValue> items = list.items();
  if (items.empty()) list.fail("has no roots; give one at least");
  expect(list, static_cast<long>(items.size()));
  std::vector<RootFrame> frames;
  for (const JsonValue& item : items) {
    item.check_keys({"position"}, {"direction"});
    const Vector3d axis = item.has("direction") ? direction(item["direction"]) : Vector3d(0, 0, -1);
    frames.push_back(frame_at(vector(item["position"], kFar), axis));
  }
  return frames;
}

std::vector<RootFrame> read_line(const JsonValue& line, const Expect& expect) {
  line.check_keys({"from", "to", "count"}, {"direction"});
  const Vector3d axis = line.has("direction") ? direction(line["direction"]) : Vector3d(0, 0, -1);
  const int count = read_count(line["count"], expect);
  return all_along(points_on_line(vector(line["from"], kFar), vector(line["to"], kFar), count), axis);
}

std::vector<RootFrame> read_disc(const JsonValue& disc, const Expect& expect) {
  disc.check_keys({"centre", "normal", "radius", "count"}, {"direction"});
  const Vector3d normal = direction(disc["normal"]);
  const Vector3d axis = disc.has("direction") ? direction(disc["direction"]) : normal;
  const int count = read_count(disc["count"], expect);
  return all_along(points_on_disc(vector(disc["centre"], kFar), normal, length(disc["radius"]), count), axis);
}

std::vector<RootFrame> read_cap(const JsonValue& cap, const Expect& expect) {
  cap.check_keys({"centre", "radius", "count"}, {"axis", "degrees", "comb", "lift"});
  if (cap.has("lift") && !cap.has("comb")) cap["lift"].fail("is of hair that is combed; give \"comb\", too");
  const Vector3d centre = vector(cap["centre"], kFar);
  const Vector3d axis = cap.has("axis") ? direction(cap["axis"]) : Vector3d(0, 0, 1);
  const double radius = length(cap["radius"]);
  const double degrees = number_or(cap, "degrees", 90, 0.1, 180), lift = number_or(cap, "lift", 0.3, 0, 1);
  const int count = read_count(cap["count"], expect);
  std::vector<RootFrame> frames;
  frames.reserve(static_cast<std::size_t>(count));
  for (const Vector3d& outward : directions_in_cap(axis, degrees * std::numbers::pi / 180, count)) {
    const Vector3d way = cap.has("comb") ? combed(outward, direction(cap["comb"]), lift) : outward;
    frames.push_back(frame_at(centre + radius * outward, way));
  }
  return frames;
}

std::vector<RootFrame> read_bust(const JsonValue& bust, const Expect& expect) {
  bust.check_keys({"count"}, {"at", "lift", "seed"});
  const Vector3d at = vector_or(bust, "at", Vector3d::Zero(), kFar);
  const double lift = number_or(bust, "lift", 0.3, 0, 1);
  const long seed = bust.has("seed") ? bust["seed"].whole_number(0, 1L << 53) : 0;
  std::vector<RootFrame> frames =
      scalp_roots(Bust(), read_count(bust["count"], expect), static_cast<std::uint64_t>(seed));
  for (RootFrame& frame : frames) frame = frame_at(at + frame.position, combed(frame.axis, frame.side, lift));
  return frames;
}

}  // namespace

std::vector<RootFrame> read_roots(const JsonValue& object, const Expect& expect) {
  const std::string kind = object.only_key({"list", "line", "disc", "cap", "bust"});
  if (kind == "list") return read_list(object[kind], expect);
  if (kind == "line") return read_line(object[kind], expect);
  if (kind == "disc") return read_disc(object[kind], expect);
  if (kind == "bust") return read_bust(object[kind], expect);
  return read_cap(object[kind], expect);
}

}  // namespace hair::json
