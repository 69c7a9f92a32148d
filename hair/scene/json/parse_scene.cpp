#include "hair/scene/json/parts.h"

namespace hair {

Scene parse_scene(const std::string& text, const std::string& name) {
  return json::scene_of(parse_document(text, name), name, {});
}

}  // namespace hair
