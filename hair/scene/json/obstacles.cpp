#include <memory>

#include "hair/head/bust.h"
#include "hair/scene/json/keys.h"
#include "hair/scene/json/parts.h"

namespace hair::json {

static void keys_of(Keys& keys, Plane& plane) {
  keys.vector("point", plane.point, {.unit = "m", .needed = true});
  keys.direction("normal", plane.normal, {.needed = true}, "to where hair may be");
}

static void keys_of(Keys& keys, Sphere& sphere) {
  keys.vector("centre", sphere.centre, {.unit = "m", .needed = true});
  keys.length("radius", sphere.radius, {.needed = true});
}

static void keys_of(Keys& keys, Capsule& capsule) {
  keys.vector("from", capsule.a, {.unit = "m", .needed = true}, "an end of its middle line");
  keys.vector("to", capsule.b, {.unit = "m", .needed = true}, "the other end");
  keys.length("radius", capsule.radius, {.needed = true});
}

namespace {

struct PlacedBust {
  Vector3d at = Vector3d::Zero();
};

void keys_of(Keys& keys, PlacedBust& bust) {
  keys.about(
      "z is up, and the face looks along -y. The head is 15 cm wide, 19 cm deep and 23 cm high; the chest "
      "ends 35 cm below the middle of the skull.");
  keys.vector("at", bust.at, {.unit = "m"}, "where the middle of its skull is");
}

decltype(Obstacle::shape) shape_of(const JsonValue& object, const ObstacleText& text) {
  if (text.plane.has_value() + text.sphere.has_value() + text.capsule.has_value() + text.bust.has_value() !=
      1)
    object.fail("give one of: plane, sphere, capsule, bust");
  if (text.plane) return read<Plane>(*text.plane);
  if (text.sphere) return read<Sphere>(*text.sphere);
  if (text.capsule) return read<Capsule>(*text.capsule);
  return PlacedSolid{std::make_shared<Bust>(), read<PlacedBust>(*text.bust).at};
}

}  // namespace

void keys_of(Keys& keys, ObstacleText& text) {
  keys.about(
      "Only hair collides; toys do not. Particles collide; the segments between them do not. One of `plane`, "
      "`sphere`, `capsule`, `bust`, and:");
  keys.any("plane", text.plane, {.objects = {object<Plane>()}}, "all that is below it");
  keys.any("sphere", text.sphere, {.objects = {object<Sphere>()}});
  keys.any("capsule", text.capsule, {.objects = {object<Capsule>()}});
  keys.any("bust", text.bust, {.objects = {object<PlacedBust>()}}, "a head with its neck and shoulders");
  keys.number("friction", text.friction, {.least = 0, .most = 1e3}, "Coulomb's mu");
  keys.text("moves_with", text.moves_with, {.otherwise = "nothing"},
            "the name of a motion. Only a sphere or a bust can move with one that turns. A sphere's surface "
            "does not turn with it");
}

void add_obstacles(const JsonValue& list, Reading& reading) {
  for (const JsonValue& item : list.items()) {
    const ObstacleText text = read<ObstacleText>(item);
    std::vector<Obstacle>& obstacles = reading.scene.hair.obstacles;
    Obstacle& made = obstacles.emplace_back();
    made.shape = shape_of(item, text);
    made.friction = text.friction;
    if (Rider* rider = reading.rider(item, text.moves_with)) {
      if (!text.sphere && !text.bust && turns(rider->motion))
        item["moves_with"].fail("this motion turns, and only a sphere or a bust can move with it");
      rider->obstacles.push_back(static_cast<int>(obstacles.size()) - 1);
    }
  }
}

}  // namespace hair::json
