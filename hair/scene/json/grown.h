// Hair that grows on a head, from JSON: a groom of a group, or hair that stays still.
#pragma once

#include "hair/scene/json/keys.h"
#include "hair/scene/scene.h"

namespace hair::json {

const Section& grown_section();
StillHair read_grown(const JsonValue& groom);

}  // namespace hair::json
