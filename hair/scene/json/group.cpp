#include "hair/scene/json/group.h"

#include <numbers>

namespace hair::json {

void keys_of(Keys& keys, Fibre& fibre) {
  constexpr double kLargestFactor = 1e12;
  Material& material = fibre.material;
  keys.number({.name = "radius", .unit = "m", .least = 1e-7, .most = 1}, material.radius);
  keys.number({.name = "density", .unit = "kg/m³", .least = 1e-3, .most = 1e6}, material.density);
  keys.number({.name = "young_modulus", .unit = "Pa", .least = 1, .most = 1e15}, material.young_modulus);
  keys.number({.name = "stretch_factor",
               .least = 0,
               .most = kLargestFactor,
               .what = "times the EA that follows from these; 0: no springs along the segments"},
              fibre.stretch_factor);
  keys.number({.name = "bend_factor",
               .least = 0,
               .most = kLargestFactor,
               .what = "times EI; 0: nothing resists bending"},
              fibre.bend_factor);
  keys.number({.name = "twist_factor",
               .least = 0,
               .most = kLargestFactor,
               .what = "times GJ, which resists twisting; not for masses and springs"},
              fibre.twist_factor);
  keys.number({.name = "skip_factor",
               .least = 0,
               .most = kLargestFactor,
               .what = "the rigidity of springs that skip a particle (H3), times EA"},
              fibre.skip_factor);
  keys.number(
      {.name = "relaxation_time",
       .unit = "s",
       .least = 0,
       .most = 1e6,
       .what = "bends and twists also resist their rates, with this times their stiffness; not for masses "
               "and springs"},
      fibre.relaxation_time);
  std::optional<double> degrees;
  keys.number({.name = "joint_limit",
               .unit = "°",
               .least = 0.1,
               .most = 180,
               .otherwise = "none",
               .what = "how far a joint of rigid links turns from its rest before it meets a buffer"},
              degrees);
  if (degrees) fibre.joint_limit = std::numbers::pi / 180 * *degrees;
}

void keys_of(Keys& keys, Held& held) {
  keys.about("Each strand is held straight in a direction, with its lengths at rest.");
  held.differently = true;
  keys.direction({.name = "direction", .needed = true}, held.direction);
  keys.number({.name = "stretch", .least = 0, .most = 100, .what = "times the lengths at rest"},
              held.stretch);
  keys.flag({.name = "folded", .what = "every other segment goes back"}, held.folded);
  keys.vector({.name = "spin", .unit = "rad/s", .what = "turns about its root, like a stick"}, held.spin);
}

void keys_of(Keys& keys, GroupText& group) {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> ids;
    for (const ModelRow& row : models()) ids.emplace_back(row.id);
    return ids;
  }();
  keys.word({.name = "model", .what = "what strands are made of; masses and springs come first"}, names,
            group.model);
  keys.part({.name = "material", .otherwise = "human hair"}, group.fibre);
  keys.flag(
      {.name = "clamped",
       .what = "a clamped strand leaves its root in the root's direction, a wave or curl along its own "
               "tangent there, and only its axis has that direction; else the root is a hinge. Wavy and "
               "curly hair must be clamped"},
      group.clamped);
  keys.part({.name = "start", .otherwise = "at rest", .what = "how it is held at the start"}, group.start);
  keys.vector({.name = "root_velocity", .unit = "m/s", .what = "of the roots, all the time"},
              group.root_velocity);
  keys.text({.name = "moves_with", .otherwise = "nothing", .what = "the name of a motion"}, group.moves_with);
  keys.part(
      {.name = "synthesis",
       .otherwise = "none",
       .what =
           "draws many strands in the place of these, which are their guides and have as many points each"},
      group.synthesis);
}

StrandSpec spec_of(const JsonValue& object, const GroupText& group) {
  if (object.has("root_velocity") && group.moves_with)
    object["root_velocity"].fail("these roots move with a motion already; keep one of the two");
  StrandSpec spec;
  spec.fibre = group.fibre;
  spec.clamped = group.clamped;
  spec.start = group.start;
  spec.root_velocity = group.root_velocity;
  return spec;
}

}  // namespace hair::json
