// STAFF ONLY. Each program with this file has the stub of one exercise, and the reference's of all others.
#include <gtest/gtest.h>

#include <algorithm>

#include "hair/scene/scene_run.h"
#include "hair/scene_drawing/scene_drawing.h"
#include "solver/not_implemented.h"

// The exercise whose stub this program has.
extern const char* const kStub;

namespace reference_tests {
namespace {

// The stub that the first step, measuring or drawing calls, or "". One hair calls the same exercises as a
// thousand, and only dense hair calls one when it is drawn.
std::string stub_of(hair::Scene scene) {
  scene.steps_per_frame = 1;
  scene.riders.clear();
  if (scene.hair.strands.size() > 1 && scene.dense.empty() && !scene.hair.mesh)
    scene.hair.strands.erase(scene.hair.strands.begin() + 1, scene.hair.strands.end());
  for (hair::DenseHair& dense : scene.dense)
    if (dense.description.children.size() > 20) dense.description.children.resize(20);
  try {
    hair::SceneRun scene_run(scene);
    scene_run.advance();
    scene_run.measure(scene_run.state());
    if (scene.dense.empty()) return "";
    hair::Scene drawn = scene;
    drawn.hair.obstacles.clear();  // they call no exercise, and take long to draw
    hair::SceneDrawing(drawn, scene_run.strands())
        .at(scene_run.centre_lines(scene_run.state()), {}, scene_run.time());
  } catch (const NotImplemented& stub) {
    const std::string said = stub.what();
    return said.substr(0, said.find(' '));
  }
  return "";
}

TEST(ExercisesOf, AreThoseThatASceneStopsWithout) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(HAIR_SCENES)) {
    if (entry.path().extension() != ".json") continue;
    const hair::Scene scene = hair::read_scene(entry.path());
    const std::vector<std::string> called = hair::exercises_of(scene);
    const bool needed = std::count(called.begin(), called.end(), kStub) > 0;
    EXPECT_EQ(stub_of(scene), needed ? kStub : "") << scene.name;
    ++scenes;
  }
  EXPECT_GT(scenes, 10);
}

}  // namespace
}  // namespace reference_tests
