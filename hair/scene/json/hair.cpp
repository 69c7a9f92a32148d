#include <cmath>
#include <numbers>
#include <stdexcept>

#include "hair/make_strand.h"
#include "hair/scene/json/parts.h"
#include "hair/scene/json/roots.h"
#include "hair/scene/json/values.h"
#include "hair/scene/variation.h"

namespace hair::json {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kMostSegments = 10'000;

struct Fibre {
  Material material;
  double stretch_factor = 1, bend_factor = 1, skip_factor = 0;

  void apply(Strand& strand) const {
    strand.stretch_rigidity *= stretch_factor;
    strand.bend_rigidity *= bend_factor;
    strand.skip_rigidity = skip_factor * strand.stretch_rigidity;
  }
};

Fibre read_fibre(const JsonValue& group) {
  Fibre fibre;
  if (!group.has("material")) return fibre;
  const JsonValue object = group["material"];
  object.check_keys({},
                    {"radius", "density", "young_modulus", "stretch_factor", "bend_factor", "skip_factor"});
  Material& material = fibre.material;
  material.radius = number_or(object, "radius", material.radius, 1e-7, 1);
  material.density = number_or(object, "density", material.density, 1e-3, 1e6);
  material.young_modulus = number_or(object, "young_modulus", material.young_modulus, 1, 1e15);
  fibre.stretch_factor = number_or(object, "stretch_factor", 1, 0, 1e12);
  fibre.bend_factor = number_or(object, "bend_factor", 1, 0, 1e12);
  fibre.skip_factor = number_or(object, "skip_factor", 0, 0, 1e12);
  return fibre;
}

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

// How it is held at the start, other than at rest: straight in a direction, every segment `stretch` times as
// long, or to and fro.
struct Held {
  bool differently = false;
  Vector3d direction;
  double stretch = 1;
  bool folded = false;

  void apply(const Strand& strand, Eigen::VectorXd& x) const {
    if (!differently) return;
    for (int i = 0; i < strand.segments(); ++i) {
      const double sign = folded && i % 2 == 1 ? -1 : 1;
      x.segment<3>(3 * i + 3) = x.segment<3>(3 * i) + sign * stretch * strand.rest_length[i] * direction;
    }
  }
};

Held read_held(const JsonValue& group) {
  if (!group.has("start")) return {};
  const JsonValue object = group["start"];
  object.check_keys({"direction"}, {"stretch", "folded"});
  return {true, direction(object["direction"]), number_or(object, "stretch", 1, 0, 100),
          boolean_or(object, "folded", false)};
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
    const RestShape rest = shape.make(segments, own, frame);
    StrandStart start;
    if (shape.kind != Shape::Kind::straight) {
      start = start_at_rest(fibre.material, rest);
    } else {
      start = {strand_from_rest(fibre.material, rest.x), {rest.x, Eigen::VectorXd::Zero(rest.x.size())}};
      start.strand.clamped = clamped;
      start.strand.root_tangent = rest.tangent;
      start.root_normal = rest.normal;
    }
    fibre.apply(start.strand);
    held.apply(start.strand, start.state.x);
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
  if (object.has("root_velocity")) {
    if (object.has("moves_with"))
      object["root_velocity"].fail("these roots move with a motion already; keep one of the two");
    group.velocity = vector(object["root_velocity"], kFast);
  }
  return group;
}

}  // namespace

void read_hair(const JsonValue& list, Reading& reading) {
  for (const JsonValue& object : list.items()) {
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
