// The table of scenes in the assignment says which exercises each scene calls.
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "hair/lab/run/shipped_scenes.h"
#include "hair/lab/tests/run_hairlab.h"
#include "hair/scene/scene.h"

namespace hair {
namespace {

TEST(SceneTable, HasTheRowOfEachSceneAndNoOthers) {
  std::set<std::string> rows;
  std::istringstream text(bytes_of(std::string(HAIR_PROJECT) + "/handout/assignment/README.md"));
  for (std::string line; std::getline(text, line);)
    if (line.starts_with("| `")) {
      EXPECT_TRUE(rows.insert(line).second) << line;
    }

  const std::filesystem::path folder = HAIR_SCENES_DIR;
  ASSERT_FALSE(shipped_scenes(folder).empty());
  for (const std::string& name : shipped_scenes(folder)) {
    const Scene scene = read_scene(folder / (name + ".json"));
    std::string ids;
    for (const std::string& id : exercises_of(scene)) ids += (ids.empty() ? "" : ", ") + id;
    const std::string row = "| `" + name + "` | " + ids + " | " + scene.shows + " |";
    EXPECT_EQ(rows.erase(row), 1u) << "it must have the row\n" << row;
  }
  for (const std::string& row : rows) ADD_FAILURE() << "no scene is as this row says\n" << row;
}

}  // namespace
}  // namespace hair
