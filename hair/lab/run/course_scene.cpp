#include "hair/lab/run/course_scene.h"

#include <algorithm>
#include <system_error>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"

namespace hair {

namespace fs = std::filesystem;

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

std::vector<std::string> shipped_scenes(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

fs::path find_scene(const std::string& scene, const fs::path& folder) {
  std::error_code ignored;
  if (fs::is_regular_file(scene, ignored)) return scene;
  const std::vector<std::string> names = shipped_scenes(folder);
  if (std::ranges::find(names, scene) != names.end()) return folder / (scene + ".json");
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  throw BadInput(printable(scene, 4096) + ": " +
                 (fs::is_directory(scene, ignored) ? "is a folder" : "there is no such file") +
                 "; give a scene's file, or the name of one that comes along: " + list);
}

Scene read_course_scene(const std::string& name, const Course& course) {
  return read_if_complete(read_scene, name, course);
}

Scene read_course_outline(const std::string& name, const Course& course) {
  return read_if_complete(read_outline, name, course);
}

}  // namespace hair
