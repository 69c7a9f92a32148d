#include "hair/lab/run/course_scene.h"

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/lab/run/shipped_scenes.h"

namespace hair {

Scene read_course_scene(const std::string& name, const Course& course) {
  const std::filesystem::path file = find_scene(name, HAIR_SCENES_DIR);
  Scene scene = read_scene(file);
  for (const std::string& id : exercises_of(scene))
    if (!course.has(id))
      throw BadInput(printable(file.string(), 4096) + ": needs exercise " + id +
                     ", which this course leaves out; play another scene");
  return scene;
}

}  // namespace hair
