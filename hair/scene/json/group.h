// The common keys of all groups of strands.
#pragma once

#include "hair/scene/json/keys.h"
#include "hair/scene/json/parts.h"
#include "hair/scene/scene.h"
#include "hair/strand/strand_spec.h"

namespace hair::json {

struct GroupText {
  std::size_t model = 0;  // its row in the table of models
  Fibre fibre;
  bool clamped = true;
  Held start;
  Vector3d root_velocity = Vector3d::Zero();
  std::optional<std::string> moves_with;
  std::optional<SynthesisText> synthesis;
};

void keys_of(Keys& keys, GroupText& group);

// Reads all of a strand specification, except roots, forms, lengths and elements. `object`: the group.
StrandSpec spec_of(const JsonValue& object, const GroupText& group);

// Hair that grows on a head: a groom of a group, or hair that stays still.
const Section& grown_section();
StillHair read_grown(const JsonValue& groom);

}  // namespace hair::json
