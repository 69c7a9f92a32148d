#include <algorithm>
#include <set>
#include <string_view>

#include "hair/mass_spring/force_parts.h"
#include "hair/scene/scene.h"
#include "hair/simulation/models.h"
#include "particles/toys/moving_toy.h"

namespace hair {

namespace {

// The exercise's index in exercises.json.
std::size_t place_of(std::string_view id) {
  constexpr std::string_view all = HAIR_EXERCISES;  // " S1 S2 "
  return all.find(" " + std::string(id) + " ");
}

}  // namespace

std::vector<std::string> exercises_of(const Scene& scene) {
  std::set<std::string> called;
  const auto add = [&](const auto& ids) {
    for (const std::string_view id : ids) called.emplace(id);
  };
  const auto calls_method = [](const ModelledStrand& strand) { return strand.model->calls_method; };
  const std::vector<ModelledStrand>& modelled = scene.hair.modelled;
  if (!scene.hair.strands.empty() || std::any_of(modelled.begin(), modelled.end(), calls_method))
    add(row_of(scene.hair.method).exercises);
  for (const StrandStart& start : scene.hair.strands) add(exercises_of(start));
  if (scene.hair.mesh) called.emplace("H9");
  for (const ModelledStrand& strand : modelled) add(strand.model->exercises(strand.spec));
  for (const Toy& toy : scene.toys) {
    for (const MethodRow& row : methods())
      if (row.toy == toy.method) add(row.exercises);
    add(particles::exercises_of_constraints(toy));
  }
  if (!scene.dense.empty()) called.emplace("H10");
  std::vector<std::string> in_order(called.begin(), called.end());
  std::ranges::sort(in_order, {}, place_of);
  return in_order;
}

}  // namespace hair
