// What all groups of strands have: what they are made of, and how they are held at the start.
#pragma once

#include "hair/io/files/strict_json.h"
#include "hair/simulation/simulation.h"
#include "hair/strand/material.h"

namespace hair::json {

struct Fibre {
  Material material;
  double stretch_factor = 1, bend_factor = 1, skip_factor = 0;

  // Straight hair bends by H2's springs; hair of another shape by its rest curvature, if it is clamped.
  StrandStart strand(const RestShape& rest, bool straight, bool clamped) const;
};

// How a strand is held at the start, if not at rest: straight in a direction, every segment `stretch` times as
// long, or to and fro.
struct Held {
  bool differently = false;
  Vector3d direction = Vector3d::Zero();
  double stretch = 1;
  bool folded = false;

  void apply(StrandStart& start) const;
};

// Of a group's "material" and "start".
Fibre read_fibre(const JsonValue& group);
Held read_held(const JsonValue& group);

// Of a group's "root_velocity". Roots that move with a motion have none of their own.
Vector3d read_root_velocity(const JsonValue& group);

}  // namespace hair::json
