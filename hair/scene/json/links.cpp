#include <algorithm>
#include <string>

#include "hair/head/control_mesh.h"
#include "hair/scene/json/parts.h"
#include "hair/scene/json/values.h"

namespace hair::json {

namespace {

constexpr double kStiffest = 1e6;   // N/m
constexpr double kStretched = 1e6;  // times a link's length

StripLaw read_strips(const JsonValue& strips) {
  strips.check_keys({"thickness", "stiffness"}, {"friction"});
  return {length(strips["thickness"]), strips["stiffness"].number(0, kStiffest),
          number_or(strips, "friction", 0, 0, 1e3)};
}

}  // namespace

void read_links(const JsonValue& object, Reading& reading) {
  object.check_keys({"stiffness"}, {"yields", "breaks", "neighbours", "strips"});
  MeshSpec spec;
  spec.stiffness = object["stiffness"].number(0, kStiffest);
  spec.yields = number_or(object, "yields", spec.yields, 0, kStretched);
  spec.breaks = number_or(object, "breaks", std::max(spec.breaks, spec.yields), 0, kStretched);
  if (spec.breaks < spec.yields)
    object["breaks"].fail("a link can't break before it yields; give \"yields\" or more");
  Neighbours which = Neighbours::rows;
  if (object.has("neighbours"))
    which = object["neighbours"].word({"rows", "both"}) == 0 ? Neighbours::rows : Neighbours::both;
  if (object.has("strips")) spec.strips = read_strips(object["strips"]);

  Description& hair = reading.scene.hair;
  if (!hair.modelled.empty())
    object.fail("links are for hair of masses and springs; leave them out, or the \"model\"");
  if (hair.method != Method::implicit_euler)
    object.fail("linked hair moves by implicit Euler; write \"method\": \"implicit_euler\"");
  const auto hinged = [](const StrandStart& start) { return !start.strand.clamped; };
  if (std::any_of(hair.strands.begin(), hair.strands.end(), hinged))
    object.fail("links are for clamped hair, whose roots have frames; leave out \"clamped\": false");
  const std::vector<Pair> pairs = neighbours(reading.rows, static_cast<int>(hair.strands.size()), which);
  if (pairs.empty()) object.fail("no hair has a neighbour; give a group with two roots or more");
  hair.mesh = control_mesh(hair.strands, pairs, spec);
}

}  // namespace hair::json
