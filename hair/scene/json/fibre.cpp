#include "hair/scene/json/fibre.h"

#include <numbers>

#include "hair/scene/json/values.h"

namespace hair::json {

Fibre read_fibre(const JsonValue& group) {
  Fibre fibre;
  if (!group.has("material")) return fibre;
  const JsonValue object = group["material"];
  object.check_keys({}, {"radius", "density", "young_modulus", "stretch_factor", "bend_factor",
                         "twist_factor", "skip_factor", "relaxation_time", "joint_limit"});
  Material& material = fibre.material;
  material.radius = number_or(object, "radius", material.radius, 1e-7, 1);
  material.density = number_or(object, "density", material.density, 1e-3, 1e6);
  material.young_modulus = number_or(object, "young_modulus", material.young_modulus, 1, 1e15);
  fibre.stretch_factor = number_or(object, "stretch_factor", 1, 0, 1e12);
  fibre.bend_factor = number_or(object, "bend_factor", 1, 0, 1e12);
  fibre.twist_factor = number_or(object, "twist_factor", 1, 0, 1e12);
  fibre.skip_factor = number_or(object, "skip_factor", 0, 0, 1e12);
  fibre.relaxation_time = number_or(object, "relaxation_time", 0, 0, 1e6);
  if (object.has("joint_limit"))
    fibre.joint_limit = std::numbers::pi / 180 * object["joint_limit"].number(0.1, 180);
  return fibre;
}

Held read_held(const JsonValue& group) {
  if (!group.has("start")) return {};
  const JsonValue object = group["start"];
  object.check_keys({"direction"}, {"stretch", "folded", "spin"});
  return {true, direction(object["direction"]), number_or(object, "stretch", 1, 0, 100),
          boolean_or(object, "folded", false), vector_or(object, "spin", Vector3d::Zero(), kFast)};
}

Vector3d read_root_velocity(const JsonValue& group) {
  if (group.has("root_velocity") && group.has("moves_with"))
    group["root_velocity"].fail("these roots move with a motion already; keep one of the two");
  return vector_or(group, "root_velocity", Vector3d::Zero(), kFast);
}

}  // namespace hair::json
