#include "hair/scene/json/parts.h"

#include <numbers>

namespace hair::json {

void keys_of(Keys& keys, Fibre& fibre) {
  constexpr double kLargestFactor = 1e12;
  Material& material = fibre.material;
  keys.number("radius", material.radius, {.unit = "m", .least = 1e-7, .most = 1});
  keys.number("density", material.density, {.unit = "kg/m³", .least = 1e-3, .most = 1e6});
  keys.number("young_modulus", material.young_modulus, {.unit = "Pa", .least = 1, .most = 1e15});
  keys.number("stretch_factor", fibre.stretch_factor, {.least = 0, .most = kLargestFactor},
              "times the EA that follows from these; 0: no springs along the segments");
  keys.number("bend_factor", fibre.bend_factor, {.least = 0, .most = kLargestFactor},
              "times EI; 0: nothing resists bending");
  keys.number("twist_factor", fibre.twist_factor, {.least = 0, .most = kLargestFactor},
              "times GJ, which resists twisting; not for masses and springs");
  keys.number("skip_factor", fibre.skip_factor, {.least = 0, .most = kLargestFactor},
              "the rigidity of springs that skip a particle (H3), times EA");
  keys.number("relaxation_time", fibre.relaxation_time, {.unit = "s", .least = 0, .most = 1e6},
              "bends and twists also resist their rates, with this times their stiffness; not for masses and "
              "springs");
  std::optional<double> degrees;
  keys.number("joint_limit", degrees, {.unit = "°", .least = 0.1, .most = 180, .otherwise = "none"},
              "how far a joint of rigid links turns from its rest before it meets a buffer");
  if (degrees) fibre.joint_limit = std::numbers::pi / 180 * *degrees;
}

void keys_of(Keys& keys, Held& held) {
  keys.about("Each strand is held straight in a direction, with its lengths at rest.");
  held.differently = true;
  keys.direction("direction", held.direction, {.needed = true});
  keys.number("stretch", held.stretch, {.least = 0, .most = 100}, "times the lengths at rest");
  keys.flag("folded", held.folded, {}, "every other segment goes back");
  keys.vector("spin", held.spin, {.unit = "rad/s"}, "turns about its root, like a stick");
}

void keys_of(Keys& keys, GroupText& group) {
  keys.word("model", group.model, words_of(models(), &ModelRow::id), {},
            "what strands are made of; masses and springs come first");
  keys.part("material", group.fibre, {.otherwise = "human hair"});
  keys.flag(
      "clamped", group.clamped, {},
      "a clamped strand leaves its root in the root's direction, a wave or curl along its own tangent there, "
      "and only its axis has that direction; else the root is a hinge. Wavy and curly hair must be clamped");
  keys.part("start", group.start, {.otherwise = "at rest"}, "how it is held at the start");
  keys.vector("root_velocity", group.root_velocity, {.unit = "m/s"}, "of the roots, all the time");
  keys.text("moves_with", group.moves_with, {.otherwise = "nothing"}, "the name of a motion");
  keys.part("synthesis", group.synthesis, {.otherwise = "none"},
            "draws many strands in the place of these, which are their guides and have as many points each");
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
