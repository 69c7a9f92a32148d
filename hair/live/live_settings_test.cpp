#include "hair/live/live_settings.h"

#include <gtest/gtest.h>

#include "hair/io/files/bad_input.h"
#include "hair/scene/scene_run.h"

namespace hair {
namespace {

const Course& course() {
  static const Course all = read_course(HAIR_EXERCISES_JSON, {});
  return all;
}

Scene scene(const std::string& name) {
  return read_scene(std::string(HAIR_SCENES_DIR) + "/" + name + ".json");
}

std::string ids(const std::string& name) {
  std::string all;
  for (const MethodRow* row : methods_for(scene(name), course())) all += std::string(row->id) + " ";
  return all;
}

TEST(LiveSettings, MultiplyStepAndStiffness) {
  const Scene before = scene("strand-swing");
  Scene after = before;
  change(after, read_settings("2 0.25 3 midpoint"), course());
  EXPECT_EQ(after.hair.method, Method::midpoint);
  EXPECT_DOUBLE_EQ(after.hair.step, 2 * before.hair.step);
  EXPECT_EQ(after.hair.wind, Vector3d(3, 0, 0));
  EXPECT_GT(after.hair.drag, 0) << "wind moves only what it drags";
  EXPECT_EQ(after.steps_per_frame, 1);
  EXPECT_DOUBLE_EQ(after.frames_per_second * after.hair.step, 1);
  const auto rigidity = [](const Scene& one) {
    return one.hair.strands.empty() ? one.hair.modelled.at(0).spec.fibre.stretch_factor
                                    : one.hair.strands.at(0).strand.stretch_rigidity;
  };
  EXPECT_DOUBLE_EQ(rigidity(after), rigidity(before) / 4);
}

TEST(LiveSettings, OfToysMultiplySpringsAndSetTheirMethod) {
  const Scene before = scene("cloth-patch");
  Scene after = before;
  change(after, read_settings("1 10 0 symplectic_euler"), course());
  EXPECT_DOUBLE_EQ(after.toys.at(0).springs.at(0).stiffness, 10 * before.toys.at(0).springs.at(0).stiffness);
  EXPECT_EQ(after.toys.at(0).method, ToyMethod::symplectic_euler);
}

TEST(LiveSettings, OneAndOneAndNoWindLeaveTheMethodAsItIs) {
  Scene one = scene("strand-swing");
  const Method method = one.hair.method;
  change(one, read_settings("1 1 0"), course());
  EXPECT_EQ(one.hair.method, method);
}

TEST(LiveSettings, OfferTheMethodsThatMoveTheScene) {
  std::string all;
  for (const MethodRow& row : methods()) all += std::string(row.id) + " ";
  EXPECT_EQ(ids("strand-swing"), all);
  EXPECT_EQ(ids("rod-pendulum"), "forward_euler symplectic_euler midpoint runge_kutta_4 ");
  EXPECT_EQ(ids("control-mesh"), "implicit_euler ");
}

// Every offer holds: a simulation with it can be assembled.
TEST(LiveSettings, OfferNoMethodThatCanNotBeAssembled) {
  for (const char* name :
       {"strand-swing", "stiff", "rigid-links", "super-helix", "rod-pendulum", "cloth-patch"})
    for (const MethodRow* row : methods_for(scene(name), course())) {
      Scene one = scene(name);
      change(one, read_settings(std::string("1 1 0 ") + row->id), course());
      EXPECT_NO_THROW(SceneRun{one}) << name << ", " << row->id;
    }
}

TEST(LiveSettings, RefuseWhatIsNone) {
  for (const char* text :
       {"", "1", "1 1", "x y 0", "0 1 0", "-1 1 0", "nan 1 0", "1 1e9 0", "1e-9 1 0", "1 1 -1", "1 1 nan"})
    EXPECT_THROW(read_settings(text), BadInput) << text;
  Scene one = scene("strand-swing");
  EXPECT_THROW(change(one, read_settings("1 1 0 magic"), course()), BadInput);
}

}  // namespace
}  // namespace hair
