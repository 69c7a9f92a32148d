#include <algorithm>
#include <vector>

#include "hair/head/hair_colours.h"
#include "hair/scene/json/parts.h"
#include "hair/scene/json/values.h"

namespace hair::json {

namespace {

Vector3d colour_or(const JsonValue& object, const std::string& key, const Vector3d& otherwise) {
  if (!object.has(key)) return otherwise;
  const auto parts = object[key].three_numbers(0, 1);
  return {parts[0], parts[1], parts[2]};
}

int pixels_or(const JsonValue& object, const std::string& key, int otherwise) {
  return object.has(key) ? static_cast<int>(object[key].whole_number(16, 4096)) : otherwise;
}

}  // namespace

Look read_look(const JsonValue& object) {
  object.check_keys({}, {"width", "root_colour", "tip_colour", "view", "look_at", "zoom", "image_width",
                         "image_height", "shadows", "hair", "colour", "camera", "links"});
  Look look;
  look.width = number_or(object, "width", look.width, 1e-6, 1);
  if (object.has("colour")) {
    std::vector<std::string_view> names;
    for (const HairColour& one : kHairColours) names.push_back(one.name);
    const HairColour& named = kHairColours[object["colour"].word(std::span<const std::string_view>(names))];
    look.root_colour = Vector3d::Map(named.root.data());
    look.tip_colour = Vector3d::Map(named.tip.data());
  }
  look.root_colour = colour_or(object, "root_colour", look.root_colour);
  look.tip_colour = colour_or(object, "tip_colour", look.tip_colour);
  if (object.has("view")) look.view = direction(object["view"]);
  if (object.has("look_at")) look.look_at = vector(object["look_at"], kFar);
  look.zoom = number_or(object, "zoom", look.zoom, 0.1, 100);
  look.image_width = pixels_or(object, "image_width", look.image_width);
  look.image_height = pixels_or(object, "image_height", look.image_height);
  look.shadows = boolean_or(object, "shadows", look.shadows);
  look.links = boolean_or(object, "links", look.links);
  if (object.has("camera")) look.frame = object["camera"].word({"room", "frame"}) == 1;
  if (object.has("hair")) look.fine_hair = object["hair"].word({"ribbons", "fine"}) == 1;
  return look;
}

}  // namespace hair::json
