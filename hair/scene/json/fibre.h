// The common keys of all groups of strands: the fibre, and how it is held at the start.
#pragma once

#include "hair/io/files/strict_json.h"
#include "hair/strand/strand_spec.h"

namespace hair::json {

// From a group's "material" and "start".
Fibre read_fibre(const JsonValue& group);
Held read_held(const JsonValue& group);

// From a group's "root_velocity". Not allowed for roots that move with a motion.
Vector3d read_root_velocity(const JsonValue& group);

}  // namespace hair::json
