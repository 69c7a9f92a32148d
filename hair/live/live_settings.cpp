#include "hair/live/live_settings.h"

#include <algorithm>
#include <set>
#include <sstream>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/simulation/models.h"

namespace hair {

namespace {

constexpr double kDragInWind = 2e-4;  // N s/m^2, for a scene without drag

bool moves(const MethodRow& method, const Scene& scene) {
  const auto model_has = [&](const ModelRow& model) { return !model.calls_method || model.moves_by(method); };
  const ModelRow& springs = models().front();
  if (scene.hair.mesh) return method.method() == scene.hair.method;
  if (!scene.hair.strands.empty() && !model_has(springs)) return false;
  if (!std::all_of(scene.hair.modelled.begin(), scene.hair.modelled.end(),
                   [&](const ModelledStrand& strand) { return model_has(*strand.model); }))
    return false;
  if (has_strands(scene)) return true;
  return method.toy && std::all_of(scene.toys.begin(), scene.toys.end(), [&](const Toy& toy) {
           return method.toy != ToyMethod::implicit_euler || toy.constraints.rows() == 0;
         });
}

bool has_choice(const Scene& scene) {
  return !has_strands(scene) || !scene.hair.strands.empty() ||
         std::any_of(scene.hair.modelled.begin(), scene.hair.modelled.end(),
                     [](const ModelledStrand& strand) { return strand.model->calls_method; });
}

void check(const char* name, double value, double most) {
  if (!(value >= 1 / most && value <= most))
    throw BadInput(std::string("the ") + name + " is " + std::to_string(value) +
                   " times the scene's; at most " + std::to_string(static_cast<int>(most)) +
                   " times as large or as small is possible");
}

// Gives roots, heads and drawn hair without a motion one that rests, so that a hand can lead them.
void let_all_ride(Scene& scene) {
  const Motion rest{{{0, Pose{}}}};
  std::set<int> strands, heads;
  for (std::size_t i = 0; i < scene.hair.strands.size() + scene.hair.modelled.size(); ++i)
    strands.insert(static_cast<int>(i));
  for (std::size_t i = 0; i < scene.hair.obstacles.size(); ++i)
    if (std::holds_alternative<PlacedSolid>(scene.hair.obstacles[i].shape)) heads.insert(static_cast<int>(i));
  for (const Rider& rider : scene.riders) {
    for (const int strand : rider.strands) strands.erase(strand);
    for (const int obstacle : rider.obstacles) heads.erase(obstacle);
  }
  if (!strands.empty())
    scene.riders.push_back({rest, {strands.begin(), strands.end()}, {heads.begin(), heads.end()}});
  for (StillHair& hair : scene.still) hair.motion = hair.motion.value_or(rest);
  for (DenseHair& hair : scene.dense) hair.motion = hair.motion.value_or(rest);
}

}  // namespace

LiveSettings read_settings(const std::string& text) {
  std::istringstream in(text);
  LiveSettings settings;
  if (!(in >> settings.step >> settings.stiffness >> settings.wind))
    throw BadInput("\"" + printable(text, 100) +
                   "\" is no step, stiffness, wind and method, such as \"1 0.5 0 midpoint\"");
  in >> settings.method;
  check("step", settings.step, kMostTimesStep);
  check("stiffness", settings.stiffness, kMostTimesStiffness);
  if (!(settings.wind >= 0 && settings.wind <= kMostWind))
    throw BadInput("the wind is " + std::to_string(settings.wind) + " m/s, which is not between 0 and 20");
  return settings;
}

std::vector<const MethodRow*> methods_for(const Scene& scene, const Course& course) {
  std::vector<const MethodRow*> all;
  if (!has_choice(scene)) return all;
  for (const MethodRow& row : methods()) {
    const bool taught = std::all_of(row.exercises.begin(), row.exercises.end(),
                                    [&](std::string_view id) { return course.has(std::string(id)); });
    if (taught && moves(row, scene)) all.push_back(&row);
  }
  return all;
}

const MethodRow* method_of(const Scene& scene) {
  if (has_strands(scene)) return &row_of(scene.hair.method);
  if (scene.toys.empty()) return nullptr;
  const ToyMethod first = scene.toys.front().method;
  for (const Toy& toy : scene.toys)
    if (toy.method != first) return nullptr;
  for (const MethodRow& row : methods())
    if (row.toy == first) return &row;
  return nullptr;
}

void change(Scene& scene, const LiveSettings& settings, const Course& course) {
  if (!settings.method.empty()) {
    const std::vector<const MethodRow*> all = methods_for(scene, course);
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const MethodRow* row) { return row->id == settings.method; });
    if (found == all.end())
      throw BadInput(scene.name + ": is not moved by the method \"" + printable(settings.method, 60) + "\"");
    scene.hair.method = (*found)->method();
    for (Toy& toy : scene.toys)
      if ((*found)->toy && !has_strands(scene)) toy.method = *(*found)->toy;
  }
  for (StrandStart& start : scene.hair.strands) {
    start.strand.stretch_rigidity *= settings.stiffness;
    start.strand.bend_rigidity *= settings.stiffness;
    start.strand.skip_rigidity *= settings.stiffness;
  }
  for (ModelledStrand& strand : scene.hair.modelled) {
    strand.spec.fibre.stretch_factor *= settings.stiffness;
    strand.spec.fibre.bend_factor *= settings.stiffness;
    strand.spec.fibre.twist_factor *= settings.stiffness;
  }
  for (Toy& toy : scene.toys)
    for (particles::Spring& spring : toy.springs) spring.stiffness *= settings.stiffness;
  scene.hair.wind += settings.wind * Vector3d::UnitX();
  if (settings.wind > 0) scene.hair.drag = std::max(scene.hair.drag, kDragInWind);
  let_all_ride(scene);
  scene.hair.step *= settings.step;
  scene.steps_per_frame = 1;
  scene.frames_per_second = 1 / scene.hair.step;
}

}  // namespace hair
