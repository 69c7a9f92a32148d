#include <algorithm>

#include "hair/scene/json/parts.h"
#include "hair/scene/json/values.h"

namespace hair::json {

namespace {

std::variant<Plane, Sphere, Capsule> read_obstacle_shape(const JsonValue& obstacle) {
  const int shapes = obstacle.has("plane") + obstacle.has("sphere") + obstacle.has("capsule");
  if (shapes != 1) obstacle.fail("give one of: plane, sphere, capsule");
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
    obstacle.check_keys({}, {"plane", "sphere", "capsule", "friction", "moves_with"});
    std::vector<Obstacle>& obstacles = reading.scene.hair.obstacles;
    Obstacle& made = obstacles.emplace_back();
    made.shape = read_obstacle_shape(obstacle);
    made.friction = number_or(obstacle, "friction", 0, 0, 1e3);
    if (Rider* rider = reading.rider(obstacle)) {
      if (!std::holds_alternative<Sphere>(made.shape) && turns(rider->motion))
        obstacle["moves_with"].fail("this motion turns, and only a sphere can move with it");
      rider->obstacles.push_back(static_cast<int>(obstacles.size()) - 1);
    }
  }
}

}  // namespace hair::json
