#include "hair/lab/run/course_scene.h"

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/lab/run/shipped_scenes.h"

namespace hair {

namespace {

Scene read_if_complete(Scene (*read)(const std::filesystem::path&), const std::string& name,
                       const Course& course) {
  const std::filesystem::path file = find_scene(name, HAIR_SCENES_DIR);
  Scene scene = read(file);
  for (const std::string& id : exercises_of(scene))
    if (!course.has(id))
      throw BadInput(printable(file.string(), 4096) + ": needs exercise " + id +
                     ", which this course leaves out; play another scene");
  return scene;
}

}  // namespace

Scene read_course_scene(const std::string& name, const Course& course) {
  return read_if_complete(read_scene, name, course);
}

Scene read_course_outline(const std::string& name, const Course& course) {
  return read_if_complete(read_outline, name, course);
}

}  // namespace hair
