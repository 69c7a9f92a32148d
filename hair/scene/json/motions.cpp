#include <cmath>
#include <numbers>
#include <optional>

#include "hair/scene/json/parts.h"
#include "hair/scene/json/values.h"

namespace hair::json {

namespace {

struct Turn {
  Vector3d axis = Vector3d::UnitZ();
  double degrees = 0;
};

Turn read_turn(const JsonValue& key) {
  if (key.has("axis") != key.has("degrees"))
    key.fail("\"axis\" and \"degrees\" go together; give both or none");
  if (!key.has("axis")) return {};
  return {direction(key["axis"]), key["degrees"].number(-3600, 3600)};
}

Motion read_keys(const JsonValue& list) {
  Motion motion;
  std::optional<Turn> before;
  for (const JsonValue& key : list.items()) {
    key.check_keys({"time"}, {"position", "axis", "degrees"});
    const double time = key["time"].number(0, 1e6);
    if (!motion.keys.empty() && !(time > motion.keys.back().time))
      key["time"].fail("is not later than the key before it; give times that increase");
    const Turn turn = read_turn(key);
    // Of two ways to turn, a motion takes the shorter.
    if (before && turn.axis == before->axis && std::abs(turn.degrees - before->degrees) > 180)
      key["degrees"].fail("is more than 180 degrees from the key before it; put keys between them");
    before = turn;
    const Pose pose{vector_or(key, "position", Vector3d::Zero(), kFar),
                    Eigen::Quaterniond(Eigen::AngleAxisd(turn.degrees * std::numbers::pi / 180, turn.axis))};
    motion.keys.push_back({time, pose});
  }
  if (motion.keys.empty()) list.fail("has no keys; give one at least");
  return motion;
}

}  // namespace

void read_motions(const JsonValue& list, Reading& reading) {
  for (const JsonValue& motion : list.items()) {
    motion.check_keys({"name", "keys"});
    if (!reading.motions.emplace(motion["name"].text(), reading.scene.riders.size()).second)
      motion["name"].fail("is the name of a motion before it; give another");
    reading.scene.riders.push_back({read_keys(motion["keys"]), {}, {}});
  }
}

Rider* Reading::rider(const JsonValue& object) {
  if (!object.has("moves_with")) return nullptr;
  const auto found = motions.find(object["moves_with"].text());
  if (found == motions.end()) object["moves_with"].fail("no motion has this name; look at \"motions\"");
  return &scene.riders[found->second];
}

}  // namespace hair::json
