#include <numbers>
#include <string_view>

#include "hair/head/bust.h"
#include "hair/head/scalp_roots.h"
#include "hair/scene/json/parts.h"
#include "hair/scene/json/values.h"
#include "hair/scene/roots.h"

namespace hair::json {

namespace {

constexpr double kGathered = 0.6;
constexpr long kMostDense = 1'000'000, kMostDensePoints = 50'000'000;

// `count` roots on the line, disc, cap or bust that a group's "roots" say, with the scalp's normals for axes. read_roots has
// checked what is read here.
std::vector<RootFrame> roots_of_scalp(const JsonValue& roots, int count) {
  std::vector<RootFrame> found;
  const auto add = [&](const std::vector<Vector3d>& points, const Vector3d& normal) {
    for (const Vector3d& point : points) found.push_back({point, normal, side_of(normal)});
  };
  if (roots.has("line")) {
    const JsonValue line = roots["line"];
    const Vector3d way = line.has("direction") ? direction(line["direction"]) : Vector3d(0, 0, -1);
    add(points_on_line(vector(line["from"], kFar), vector(line["to"], kFar), count), way);
  } else if (roots.has("disc")) {
    const JsonValue disc = roots["disc"];
    const Vector3d normal = direction(disc["normal"]);
    add(points_on_disc(vector(disc["centre"], kFar), normal, length(disc["radius"]), count), normal);
  } else if (roots.has("cap")) {
    const JsonValue cap = roots["cap"];
    const Vector3d centre = vector(cap["centre"], kFar),
                   axis = cap.has("axis") ? direction(cap["axis"]) : Vector3d(0, 0, 1);
    const double radius = length(cap["radius"]),
                 angle = number_or(cap, "degrees", 90, 0.1, 180) * std::numbers::pi / 180;
    for (const Vector3d& normal : directions_in_cap(axis, angle, count))
      add({centre + radius * normal}, normal);
  } else if (roots.has("bust")) {
    const JsonValue bust = roots["bust"];
    const Vector3d at = vector_or(bust, "at", Vector3d::Zero(), kFar);
    const long seed = bust.has("seed") ? bust["seed"].whole_number(0, 1L << 53) : 0;
    for (const RootFrame& root : scalp_roots(Bust(), count, static_cast<std::uint64_t>(seed)))
      add({at + root.position}, root.axis);
  }
  return found;
}

}  // namespace

void read_synthesis(const JsonValue& group, int first, int count, int points, Reading& reading) {
  const JsonValue object = group["synthesis"];
  object.check_keys({"strands"},
                    {"mode", "spread", "jitter", "length", "seed", "clump", "gathered", "fly_aways"});
  const JsonValue roots = group["roots"];
  if (roots.has("list")) roots.fail("a list has no place for more roots; write a line, disc, cap or bust");
  const auto strands = static_cast<int>(object["strands"].whole_number(1, kMostDense));
  reading.dense_points += static_cast<long>(strands) * points;
  if (reading.dense_points > kMostDensePoints)
    object["strands"].fail("makes " + std::to_string(reading.dense_points) +
                           " points in all; a scene draws at most " + std::to_string(kMostDensePoints));

  DenseHair dense{first, {}, {}};
  SynthesisDescription& made = dense.description;
  made.guides = roots_of_scalp(roots, count);
  made.children = roots_of_scalp(roots, strands);
  made.points = points;
  if (object.has("mode"))
    made.mode = static_cast<SynthesisMode>(object["mode"].word({"interpolate", "extrapolate", "blend"}));
  made.spread = number_or(object, "spread", made.spread, 0, 100);
  made.jitter = number_or(object, "jitter", made.jitter, 0, 1);
  made.length = number_or(object, "length", made.length, 0, 0.9);
  if (object.has("clump")) made.clump = static_cast<int>(object["clump"].whole_number(0, kMostDense));
  made.gathered = number_or(object, "gathered", made.clump > 0 ? kGathered : 0, 0, 1);
  made.fly_aways = number_or(object, "fly_aways", made.fly_aways, 0, 1);
  if (object.has("seed")) made.seed = static_cast<std::uint64_t>(object["seed"].whole_number(0, 1L << 53));
  if (const Rider* const rider = reading.rider(group)) dense.motion = rider->motion;
  reading.scene.dense.push_back(std::move(dense));
}

}  // namespace hair::json
