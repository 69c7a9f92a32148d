#include <cmath>
#include <numbers>
#include <stdexcept>

#include "hair/scene/json/fibre.h"
#include "hair/scene/json/parts.h"
#include "hair/scene/json/roots.h"
#include "hair/scene/json/values.h"
#include "hair/scene/variation.h"

namespace hair::json {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kMostSegments = 10'000;

// The shape at rest. A wave's or curl's two numbers, m.
struct Shape {
  enum class Kind { straight, wavy, curly } kind = Kind::straight;
  double across = 0, along = 0;

  RestShape make(int segments, double length, const RootFrame& frame) const {
    switch (kind) {
      case Kind::wavy:
        return wavy_shape(segments, length, across, along, frame);
      case Kind::curly:
        return curly_shape(segments, length, across, along, frame);
      default:
        return straight_shape(segments, length, frame);
    }
  }
};

Shape read_shape(const JsonValue& group) {
  if (!group.has("shape")) return {};
  const JsonValue object = group["shape"];
  const std::string kind = object.only_key({"wavy", "curly"});
  const JsonValue numbers = object[kind];
  if (kind == "wavy") {
    numbers.check_keys({"amplitude", "wavelength"});
    return {Shape::Kind::wavy, numbers["amplitude"].number(0, kLongest), length(numbers["wavelength"])};
  }
  numbers.check_keys({"radius", "pitch"});
  return {Shape::Kind::curly, numbers["radius"].number(0, kLongest), length(numbers["pitch"])};
}

struct Spread {
  double length = 0, tilt = 0, turn = 0;
  std::uint64_t seed = 0;
};

Spread read_spread(const JsonValue& group) {
  if (!group.has("variation")) return {};
  const JsonValue object = group["variation"];
  object.check_keys({}, {"seed", "length", "tilt", "turn"});
  Spread spread;
  spread.length = number_or(object, "length", 0, 0, 0.9);
  spread.tilt = kDegree * number_or(object, "tilt", 0, 0, 90);
  spread.turn = kDegree * number_or(object, "turn", 0, 0, 180);
  if (object.has("seed")) spread.seed = static_cast<std::uint64_t>(object["seed"].whole_number(0, 1L << 53));
  return spread;
}

struct Group {
  Fibre fibre;
  Shape shape;
  Held held;
  Spread spread;
  int segments = 0;
  double length = 0;
  bool clamped = true;
  Vector3d velocity = Vector3d::Zero();

  StrandStart make(RootFrame frame, Variation& variation) const {
    const double own = length * (1 + variation.uniform(-spread.length, spread.length));
    frame = varied(frame, spread.tilt, spread.turn, variation);
    StrandStart start =
        fibre.strand(shape.make(segments, own, frame), shape.kind == Shape::Kind::straight, clamped);
    held.apply(start);
    start.state.v.head<3>() = velocity;
    return start;
  }
};

Group read_group(const JsonValue& object) {
  object.check_keys({"segments", "length", "roots"},
                    {"material", "shape", "clamped", "start", "variation", "root_velocity", "moves_with"});
  Group group;
  group.segments = static_cast<int>(object["segments"].whole_number(1, kMostSegments));
  group.length = length(object["length"]);
  group.fibre = read_fibre(object);
  group.shape = read_shape(object);
  group.held = read_held(object);
  group.spread = read_spread(object);
  group.clamped = boolean_or(object, "clamped", true);
  if (!group.clamped && group.shape.kind != Shape::Kind::straight)
    object["clamped"].fail("wavy and curly hair must be clamped; write true, or leave the shape out");
  group.velocity = read_root_velocity(object);
  return group;
}

}  // namespace

void read_hair(const JsonValue& list, Reading& reading) {
  for (const JsonValue& object : list.items()) {
    if (object.has("groom")) {
      read_groom(object, reading);
      continue;
    }
    const Group group = read_group(object);
    const auto expect = [&](const JsonValue& where, long count) {
      reading.expect(where, count, group.segments + 1L);
    };
    std::vector<StrandStart>& strands = reading.scene.hair.strands;
    Rider* const rider = reading.rider(object);
    Variation variation(group.spread.seed);
    for (const RootFrame& frame : read_roots(object["roots"], expect)) {
      if (rider) rider->strands.push_back(static_cast<int>(strands.size()));
      try {
        strands.push_back(group.make(frame, variation));
      } catch (const std::invalid_argument& error) {
        object.fail(error.what());
      }
    }
  }
}

}  // namespace hair::json
