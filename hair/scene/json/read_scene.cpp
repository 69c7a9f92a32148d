#include "hair/groom/groom_file.h"
#include "hair/io/files/bad_input.h"
#include "hair/scene/json/parts.h"

namespace hair {

namespace {

json::Reading reading_beside(const std::filesystem::path& file) {
  json::Reading reading;
  reading.groom = [folder = file.parent_path()](const JsonValue& name) {
    try {
      return read_groom(folder / name.text()).strands;
    } catch (const BadInput& error) {
      name.fail(error.what());
    }
  };
  return reading;
}

}  // namespace

Scene read_scene(const std::filesystem::path& file) {
  return json::scene_of(read_document(file), file, reading_beside(file));
}

Scene read_outline(const std::filesystem::path& file) {
  json::Reading reading = reading_beside(file);
  reading.most_strands = 4;  // roots that are not on a line have space for dense hair between them
  return json::scene_of(read_document(file), file, std::move(reading));
}

}  // namespace hair
