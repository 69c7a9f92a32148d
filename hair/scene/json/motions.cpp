#include <cmath>
#include <numbers>

#include "hair/scene/json/keys.h"
#include "hair/scene/json/parts.h"

namespace hair::json {

namespace {

struct MotionKey {
  double time = 0;
  Vector3d position = Vector3d::Zero(), axis = Vector3d::UnitZ();
  double degrees = 0;
};

void keys_of(Keys& keys, MotionKey& key) {
  keys.about(
      "At the first key, a moving thing is where the scene puts it. It turns about the key's `position`. "
      "From one key to the next it speeds up and slows down. It rests before the first key and after the "
      "last.");
  keys.number("time", key.time, {.unit = "s", .needed = true, .least = 0, .most = 1e6},
              "later than the key before it");
  keys.vector("position", key.position, {.unit = "m"});
  keys.direction("axis", key.axis, {}, "of the rotation; goes with `degrees`");
  keys.number("degrees", key.degrees, {.unit = "°", .least = -3600, .most = 3600},
              "at most 180 from one key to the next");
}

Motion read_keys(const JsonValue& list) {
  Motion motion;
  std::optional<MotionKey> before;
  for (const JsonValue& object : list.items()) {
    const MotionKey key = read<MotionKey>(object);
    if (before && !(key.time > before->time))
      object["time"].fail("is not later than the key before it; give times that increase");
    if (object.has("axis") != object.has("degrees"))
      object.fail("\"axis\" and \"degrees\" go together; give both or none");
    // A motion takes the shorter of two ways to turn.
    if (before && key.axis == before->axis && std::abs(key.degrees - before->degrees) > 180)
      object["degrees"].fail("is more than 180 degrees from the key before it; put keys between them");
    const Eigen::AngleAxisd turn(key.degrees * std::numbers::pi / 180, key.axis);
    motion.keys.push_back({key.time, {key.position, Eigen::Quaterniond(turn)}});
    before = key;
  }
  if (motion.keys.empty()) list.fail("has no keys; give one at least");
  return motion;
}

}  // namespace

void keys_of(Keys& keys, MotionText& motion) {
  keys.text("name", motion.name, {.needed = true}, "what `moves_with` says");
  keys.list("keys", motion.keys, {.needed = true, .objects = {object<MotionKey>()}}, "where it is when");
}

void add_motions(const JsonValue& list, Reading& reading) {
  for (const JsonValue& item : list.items()) {
    const MotionText motion = read<MotionText>(item);
    if (!reading.motions.emplace(motion.name, reading.scene.riders.size()).second)
      item["name"].fail("is the name of a motion before it; give another");
    reading.scene.riders.push_back({read_keys(*motion.keys), {}, {}});
  }
}

Rider* Reading::rider(const JsonValue& object, const std::optional<std::string>& moves_with) {
  if (!moves_with) return nullptr;
  const auto found = motions.find(*moves_with);
  if (found == motions.end()) object["moves_with"].fail("no motion has this name; look at \"motions\"");
  return &scene.riders[found->second];
}

}  // namespace hair::json
