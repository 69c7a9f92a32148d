#include "hair/head/groom_file.h"
#include "hair/io/files/bad_input.h"
#include "hair/scene/json/parts.h"

namespace hair {

Scene read_scene(const std::filesystem::path& file) {
  json::Reading reading;
  reading.groom = [&](const JsonValue& name) {
    try {
      return read_groom(file.parent_path() / name.text()).strands;
    } catch (const BadInput& error) {
      name.fail(error.what());
    }
  };
  return json::scene_of(read_document(file), file, std::move(reading));
}

}  // namespace hair
