#include "hair/head/hair_colours.h"
#include "hair/scene/json/keys.h"
#include "hair/scene/json/parts.h"

namespace hair::json {

namespace {

KeySpec pixels(const char* name) {
  return {.name = name, .unit = "pixels", .least = 16, .most = 4096};
}

void named_colours(Keys& keys, Look& look) {
  std::vector<std::string_view> names;
  for (const HairColour& one : kHairColours) names.push_back(one.name);
  std::optional<std::size_t> named;
  keys.word({.name = "colour", .otherwise = "", .what = "sets both colours below, where they are not given"},
            names, named);
  if (!named) return;
  look.root_colour = Vector3d::Map(kHairColours[*named].root.data());
  look.tip_colour = Vector3d::Map(kHairColours[*named].tip.data());
}

}  // namespace

void keys_of(Keys& keys, Look& look) {
  keys.about("Nothing here changes how hair moves. `{}` is enough. Colours are linear: red, green and blue.");
  keys.number({.name = "width", .unit = "m", .least = 1e-6, .most = 1, .what = "of a strand as it is drawn"},
              look.width);
  keys.word(
      {.name = "hair",
       .what = "fine: as thin as `width` says, by how much of each pixel it covers, with tapered tips and "
               "colours that differ; ribbons are half a pixel wide at least"},
      {"ribbons", "fine"}, look.fine_hair);
  named_colours(keys, look);
  keys.vector({.name = "root_colour", .least = 0, .most = 1}, look.root_colour);
  keys.vector({.name = "tip_colour", .least = 0, .most = 1}, look.tip_colour);
  keys.direction(
      {.name = "view", .what = "from the scene to the camera, which moves back until it sees everything"},
      look.view);
  keys.vector({.name = "look_at",
               .unit = "m",
               .otherwise = "the middle of everything",
               .what = "what is in the picture's middle"},
              look.look_at);
  keys.word(
      {.name = "camera",
       .what = "room: sees a box with room for hair that swings; frame: as near as hair, where it starts "
               "and where it hangs, and obstacles allow"},
      {"room", "frame"}, look.frame);
  keys.number({.name = "zoom",
               .least = 0.1,
               .most = 100,
               .what = "times as near; above 1 something may be outside of the picture"},
              look.zoom);
  keys.whole(pixels("image_width"), look.image_width);
  keys.whole(pixels("image_height"), look.image_height);
  keys.flag({.name = "shadows"}, look.shadows);
  keys.flag(
      {.name = "links",
       .what =
           "of the control mesh those that are not broken are drawn, from guide to guide; not where dense "
           "hair is drawn in the place of guides"},
      look.links);
}

}  // namespace hair::json
