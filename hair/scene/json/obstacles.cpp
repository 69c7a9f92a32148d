#include <memory>

#include "hair/head/bust.h"
#include "hair/scene/json/keys.h"
#include "hair/scene/json/parts.h"

namespace hair::json {

static void keys_of(Keys& keys, Plane& plane) {
  keys.vector({.name = "point", .unit = "m", .needed = true}, plane.point);
  keys.direction({.name = "normal", .needed = true, .what = "to where hair may be"}, plane.normal);
}

static void keys_of(Keys& keys, Sphere& sphere) {
  keys.vector({.name = "centre", .unit = "m", .needed = true}, sphere.centre);
  keys.number(a_length({.name = "radius", .needed = true}), sphere.radius);
}

static void keys_of(Keys& keys, Capsule& capsule) {
  keys.vector({.name = "from", .unit = "m", .needed = true, .what = "an end of its middle line"}, capsule.a);
  keys.vector({.name = "to", .unit = "m", .needed = true, .what = "the other end"}, capsule.b);
  keys.number(a_length({.name = "radius", .needed = true}), capsule.radius);
}

namespace {

struct PlacedBust {
  Vector3d at = Vector3d::Zero();
};

void keys_of(Keys& keys, PlacedBust& bust) {
  keys.about(
      "z is up, and the face looks along -y. The head is 15 cm wide, 19 cm deep and 23 cm high; the chest "
      "ends 35 cm below the middle of the skull.");
  keys.vector({.name = "at", .unit = "m", .what = "where the middle of its skull is"}, bust.at);
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
      "Only hair collides; toys do not. Particles collide; the segments between them do not. One of "
      "`plane`, `sphere`, `capsule`, `bust`, and:");
  keys.any({.name = "plane", .what = "all that is below it"}, text.plane, {object<Plane>()});
  keys.any({.name = "sphere"}, text.sphere, {object<Sphere>()});
  keys.any({.name = "capsule"}, text.capsule, {object<Capsule>()});
  keys.any({.name = "bust", .what = "a head with its neck and shoulders"}, text.bust, {object<PlacedBust>()});
  keys.number({.name = "friction", .least = 0, .most = 1e3, .what = "Coulomb's mu"}, text.friction);
  keys.text({.name = "moves_with",
             .otherwise = "nothing",
             .what = "the name of a motion. Only a sphere or a bust can move with one that turns. A sphere's "
                     "surface does not turn with it"},
            text.moves_with);
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
