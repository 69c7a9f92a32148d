#include "hair/head/hair_colours.h"
#include "hair/scene/json/keys.h"
#include "hair/scene/json/parts.h"

namespace hair::json {

namespace {

const KeySpec kPixels{.unit = "pixels", .least = 16, .most = 4096};

void named_colours(Keys& keys, Look& look) {
  std::optional<std::size_t> named;
  keys.word("colour", named, words_of(kHairColours, &HairColour::name), {.otherwise = ""},
            "sets both colours below, where they are not given");
  if (!named) return;
  look.root_colour = Vector3d::Map(kHairColours[*named].root.data());
  look.tip_colour = Vector3d::Map(kHairColours[*named].tip.data());
}

}  // namespace

void keys_of(Keys& keys, Look& look) {
  keys.about("Nothing here changes how hair moves. `{}` is enough. Colours are linear: red, green and blue.");
  keys.number("width", look.width, {.unit = "m", .least = 1e-6, .most = 1}, "of a strand as it is drawn");
  keys.word("hair", look.fine_hair, {"ribbons", "fine"}, {},
            "fine: as thin as `width` says, by how much of each pixel it covers, with tapered tips and "
            "colours that differ; ribbons are half a pixel wide at least");
  named_colours(keys, look);
  keys.vector("root_colour", look.root_colour, {.least = 0, .most = 1});
  keys.vector("tip_colour", look.tip_colour, {.least = 0, .most = 1});
  keys.direction("view", look.view, {},
                 "from the scene to the camera, which moves back until it sees everything");
  keys.vector("look_at", look.look_at, {.unit = "m", .otherwise = "the middle of everything"},
              "what is in the picture's middle");
  keys.word("camera", look.frame, {"room", "frame"}, {},
            "room: sees a box with room for hair that swings; frame: as near as hair, where it starts and "
            "where it hangs, and obstacles allow");
  keys.number("zoom", look.zoom, {.least = 0.1, .most = 100},
              "times as near; above 1 something may be outside of the picture");
  keys.whole("image_width", look.image_width, kPixels);
  keys.whole("image_height", look.image_height, kPixels);
  keys.flag("shadows", look.shadows);
  keys.flag("links", look.links, {},
            "of the control mesh those that are not broken are drawn, from guide to guide; not where dense "
            "hair is drawn in the place of guides");
}

}  // namespace hair::json
