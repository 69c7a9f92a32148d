// STAFF ONLY. Makes the handout's texts about scenes: make_scene_texts EXERCISES.json SCENES DIR.
// DIR/scenes.md is the table of the scenes in the folder SCENES, by the exercise that completes what they
// call; DIR/scene-keys.md has all keys of a scene.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <string>

#include "hair/course/course.h"
#include "hair/io/files/write_file.h"
#include "hair/scene/scene.h"

namespace {

namespace fs = std::filesystem;

std::string scene_table(const hair::Course& course, const fs::path& folder) {
  std::map<std::pair<std::ptrdiff_t, std::string>, std::string> rows;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    const hair::Scene scene = hair::read_scene(entry.path());
    std::string calls;
    std::ptrdiff_t last = 0;
    for (const std::string& id : hair::exercises_of(scene)) {
      calls += (calls.empty() ? "" : ", ") + id;
      last = std::find_if(course.exercises.begin(), course.exercises.end(),
                          [&](const hair::Exercise& exercise) { return exercise.id == id; }) -
             course.exercises.begin();
    }
    rows[{last, scene.name}] =
        "| [" + scene.name + "](" + scene.name + ".json) | " + calls + " | " + scene.shows + " |\n";
  }
  std::string table =
      "# The scenes that come along\n\n`hairlab run NAME` plays one, once the exercises that it calls are "
      "written. "
      "How to write your own: [README.md](README.md).\n\n| scene | calls | shows |\n|---|---|---|\n";
  for (const auto& [place, row] : rows) table += row;
  return table;
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 4) {
    std::fprintf(stderr, "make_scene_texts EXERCISES.json SCENES DIR\n");
    return 2;
  }
  const fs::path out = arguments[3];
  hair::write_file(out / "scenes.md", scene_table(hair::read_course(arguments[1]), arguments[2]));
  hair::write_file(out / "scene-keys.md", hair::scene_keys());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "make_scene_texts: %s\n", error.what());
  return 1;
}
