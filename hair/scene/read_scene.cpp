#include "hair/scene/json/parts.h"

namespace hair {

Scene read_scene(const std::filesystem::path& file) {
  return json::scene_of(read_json(file), file, {});
}

}  // namespace hair
