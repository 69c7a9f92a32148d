// What all groups of strands have: what they are made of, and how they are held at the start.
#pragma once

#include "hair/io/files/strict_json.h"
#include "hair/strand/strand_spec.h"

namespace hair::json {

// Of a group's "material" and "start".
Fibre read_fibre(const JsonValue& group);
Held read_held(const JsonValue& group);

// Of a group's "root_velocity". Roots that move with a motion have none of their own.
Vector3d read_root_velocity(const JsonValue& group);

}  // namespace hair::json
