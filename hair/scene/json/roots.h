// Roots of a group of strands, from JSON.
#pragma once

#include <cstdint>
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

// Calls `expect` with the number of roots before making any; it throws for too many, and returns the number
// to make. A list is made whole. `object`: the one that `roots` was read from.
std::vector<RootFrame> make_roots(const JsonValue& object, const Roots& roots,
                                  const std::function<int(const JsonValue& where, long count)>& expect);

struct GroupScalp {
  std::vector<RootFrame> guides;  // for each of the group's strands; axis: the scalp's normal
  bool combed = false;            // the sides of all roots are the directions in which hair is combed
  // Spreads roots evenly over the scalp; returns none if it has no area.
  std::function<std::vector<RootFrame>(int count, std::uint64_t seed)> more;
};

// The scalp of roots on a line, a disc, a cap or a bust, with `count` guides.
GroupScalp scalp_of(const Roots& roots, int count);

// The scalp of roots on an unknown surface. axis: the direction in which hair leaves its root.
GroupScalp scalp_of(const std::vector<RootFrame>& roots);

}  // namespace hair::json
