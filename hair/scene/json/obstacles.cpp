#include <memory>

#include "hair/head/bust.h"
#include "hair/scene/json/parts.h"
#include "hair/scene/json/values.h"

namespace hair::json {

namespace {

decltype(Obstacle::shape) read_obstacle_shape(const JsonValue& obstacle) {
  const int shapes =
      obstacle.has("plane") + obstacle.has("sphere") + obstacle.has("capsule") + obstacle.has("bust");
  if (shapes != 1) obstacle.fail("give one of: plane, sphere, capsule, bust");
  if (obstacle.has("bust")) {
    const JsonValue bust = obstacle["bust"];
    bust.check_keys({}, {"at"});
    return PlacedSolid{std::make_shared<Bust>(), vector_or(bust, "at", Vector3d::Zero(), kFar)};
  }
  if (obstacle.has("plane")) {
    const JsonValue plane = obstacle["plane"];
    plane.check_keys({"point", "normal"});
    return Plane{vector(plane["point"], kFar), direction(plane["normal"])};
  }
  if (obstacle.has("sphere")) {
    const JsonValue sphere = obstacle["sphere"];
    sphere.check_keys({"centre", "radius"});
    return Sphere{vector(sphere["centre"], kFar), length(sphere["radius"])};
  }
  const JsonValue capsule = obstacle["capsule"];
  capsule.check_keys({"from", "to", "radius"});
  return Capsule{vector(capsule["from"], kFar), vector(capsule["to"], kFar), length(capsule["radius"])};
}

}  // namespace

void read_obstacles(const JsonValue& list, Reading& reading) {
  for (const JsonValue& obstacle : list.items()) {
    obstacle.check_keys({}, {"plane", "sphere", "capsule", "bust", "friction", "moves_with"});
    std::vector<Obstacle>& obstacles = reading.scene.hair.obstacles;
    Obstacle& made = obstacles.emplace_back();
    made.shape = read_obstacle_shape(obstacle);
    made.friction = number_or(obstacle, "friction", 0, 0, 1e3);
    if (Rider* rider = reading.rider(obstacle)) {
      if (!obstacle.has("sphere") && !obstacle.has("bust") && turns(rider->motion))
        obstacle["moves_with"].fail("this motion turns, and only a sphere or a bust can move with it");
      rider->obstacles.push_back(static_cast<int>(obstacles.size()) - 1);
    }
  }
}

}  // namespace hair::json
