// STAFF ONLY. Divides scenes into the parts of a study.
#include "grader/judge/study/parts.h"

#include <nlohmann/json.hpp>

namespace grader::inline judge {
namespace {

using nlohmann::json;

constexpr int kFewestFrames = 3;
constexpr int kCoarser = 5, kFinerHair = 4,
              kFinerToy = 3;  // multiply the steps; toys have many already

struct Known {
  const char* name;
  int order;
};

Known known(hair::Method method) {
  const hair::MethodRow& row = hair::row_of(method);
  return {row.name, row.order};
}

Known known(hair::ToyMethod method) {
  for (const hair::MethodRow& row : hair::methods())
    if (row.toy == method) return {row.name, row.order};
  return {"", 1};
}

StudiedPart part_of(const json& scene, const std::string& name) {
  StudiedPart part{name, scene.dump(), {}, 1};
  part.scene = hair::parse_scene(part.json, name);
  const Known method =
      part.scene.toys.empty() ? known(part.scene.hair.method) : known(part.scene.toys.front().method);
  part.name += std::string(", ") + method.name;
  part.order = method.order;
  return part;
}

}  // namespace

std::vector<StudiedPart> parts_of(const SceneText& text) {
  const json scene = json::parse(text.json);
  if (!scene.contains("toys")) return {part_of(scene, text.name)};
  std::vector<StudiedPart> parts;
  for (const json& toy : scene["toys"]) {
    json one = scene;
    one["toys"] = json::array({toy});
    parts.push_back(part_of(one, text.name));
  }
  return parts;
}

SceneText divided(const StudiedPart& part, const Division& division) {
  json scene = json::parse(part.json);
  scene["frames"] = division.frames;
  scene["frames_per_second"] = division.frames * part.scene.frames_per_second / part.scene.frames;
  scene["steps_per_frame"] = division.steps_per_frame;
  return {part.name, scene.dump()};
}

std::vector<Division> divisions_of(const hair::Scene& scene) {
  std::vector<Division> all = {{scene.frames, scene.steps_per_frame}};
  for (int k = 0; k < kCoarser; ++k) {
    Division coarser = all.front();
    if (coarser.steps_per_frame % 2 == 0)
      coarser.steps_per_frame /= 2;
    else if (coarser.frames % 2 == 0 && coarser.frames / 2 >= kFewestFrames)
      coarser.frames /= 2;
    else
      break;
    all.insert(all.begin(), coarser);
  }
  for (int k = 0; k < (scene.toys.empty() ? kFinerHair : kFinerToy); ++k)
    all.push_back({scene.frames, all.back().steps_per_frame * 2});
  return all;
}

std::vector<Division> between(const Division& coarse) {
  std::vector<Division> all;
  for (int steps = coarse.steps_per_frame + 1; steps < 2 * coarse.steps_per_frame; ++steps)
    all.push_back({coarse.frames, steps});
  return all;
}

}  // namespace grader::judge
