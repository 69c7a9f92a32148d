#include <algorithm>

#include "hair/scene/json/keys.h"
#include "hair/scene/json/parts.h"

namespace hair::json {

namespace {

constexpr double kStiffest = 1e6;   // N/m
constexpr double kStretched = 1e6;  // times a link's length

}  // namespace

void keys_of(Keys& keys, StripLaw& strips) {
  keys.length(
      "thickness", strips.thickness, {.needed = true},
      "particles that are nearer to a strip are pushed away; in a step they should move by less than this");
  keys.number("stiffness", strips.stiffness, {.unit = "N/m", .needed = true, .least = 0, .most = kStiffest},
              "of this push, where hairs cross");
  keys.number("friction", strips.friction, {.least = 0, .most = 1e3}, "of hair that slips along a strip");
}

void keys_of(Keys& keys, LinksText& links) {
  keys.about(
      "Each group of `hair` is a row of guides, in the order of its roots. Neighbours in a row are linked, "
      "and linked hair is one system: its `method` is `implicit_euler`, and it is of masses and springs, and "
      "clamped.");
  MeshSpec& spec = links.spec;
  keys.number("stiffness", spec.stiffness, {.unit = "N/m", .needed = true, .least = 0, .most = kStiffest},
              "of a link; one goes from each particle of a guide to the nearest one of the guide before");
  keys.number("yields", spec.yields, {.least = 0, .most = kStretched},
              "the stretch, over the link's length, from which on it loses stiffness for good");
  spec.breaks = std::max(spec.breaks, spec.yields);
  keys.number("breaks", spec.breaks, {.least = 0, .most = kStretched},
              "the stretch that breaks it; at least `yields`");
  keys.word("neighbours", links.neighbours, {"rows", "both"}, {},
            "both: a guide is also linked to the one in its place in the next row, as on a brush");
  keys.part("strips", spec.strips, {.otherwise = "none"},
            "strips of triangles between neighbours, which other guides can't go through");
}

void add_links(const JsonValue& object, const LinksText& links, Reading& reading) {
  const MeshSpec& spec = links.spec;
  if (spec.breaks < spec.yields)
    object["breaks"].fail("a link can't break before it yields; give \"yields\" or more");
  Description& hair = reading.scene.hair;
  if (!hair.modelled.empty())
    object.fail("links are for hair of masses and springs; leave them out, or the \"model\"");
  if (hair.method != Method::implicit_euler)
    object.fail("linked hair moves by implicit Euler; write \"method\": \"implicit_euler\"");
  const auto hinged = [](const StrandStart& start) { return !start.strand.clamped; };
  if (std::any_of(hair.strands.begin(), hair.strands.end(), hinged))
    object.fail("links are for clamped hair, whose roots have frames; leave out \"clamped\": false");
  const std::vector<Pair> pairs =
      neighbours(reading.rows, static_cast<int>(hair.strands.size()), links.neighbours);
  if (pairs.empty()) object.fail("no hair has a neighbour; give a group with two roots or more");
  hair.mesh = control_mesh(hair.strands, pairs, spec);
}

}  // namespace hair::json
