// Roots of a group of strands, from JSON.
#pragma once

#include <functional>
#include <vector>

#include "hair/scene/json/keys.h"
#include "hair/strand/rest_shape.h"

namespace hair::json {

struct RootLine {
  Vector3d from, to;
  int count;
  Vector3d direction = {0, 0, -1};
};

struct RootDisc {
  Vector3d centre, normal;
  double radius;
  int count;
  std::optional<Vector3d> direction;
};

struct RootCap {
  Vector3d centre;
  double radius;
  int count;
  Vector3d axis = Vector3d::UnitZ();
  double degrees = 90;
};

// Exactly one of them has a value.
struct Roots {
  std::optional<JsonValue> list;
  std::optional<RootLine> line;
  std::optional<RootDisc> disc;
  std::optional<RootCap> cap;
};

void keys_of(Keys& keys, Roots& roots);

// On the cap, along its normals.
std::vector<RootFrame> on_cap(const RootCap& cap, int count);

// Calls `expect` with the number of roots before making any; it throws for too many, and returns the number
// to make. A list is made whole. `object`: the one that `roots` was read from.
std::vector<RootFrame> make_roots(const JsonValue& object, const Roots& roots,
                                  const std::function<int(const JsonValue& where, long count)>& expect);

}  // namespace hair::json
