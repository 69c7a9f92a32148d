#include <algorithm>
#include <array>
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

class Called {
 public:
  template <class Ids>
  void add(const Ids& ids) {
    for (const std::string_view id : ids)
      if (std::find(ids_.begin(), ids_.end(), id) == ids_.end()) ids_.emplace_back(id);
  }
  std::vector<std::string> take() {
    std::sort(ids_.begin(), ids_.end(),
              [](const std::string& a, const std::string& b) { return place_of(a) < place_of(b); });
    return std::move(ids_);
  }

 private:
  std::vector<std::string> ids_;
};

}  // namespace

std::vector<std::string> exercises_of(const Scene& scene) {
  Called called;
  const auto calls_method = [](const ModelledStrand& strand) { return strand.model->calls_method; };
  const std::vector<ModelledStrand>& modelled = scene.hair.modelled;
  if (!scene.hair.strands.empty() || std::any_of(modelled.begin(), modelled.end(), calls_method))
    called.add(row_of(scene.hair.method).exercises);
  for (const StrandStart& start : scene.hair.strands) called.add(exercises_of(start));
  if (scene.hair.mesh) called.add(std::array{std::string_view("H9")});
  for (const ModelledStrand& strand : modelled) called.add(strand.model->exercises(strand.spec));
  for (const Toy& toy : scene.toys) {
    for (const MethodRow& row : methods())
      if (row.toy == toy.method) called.add(row.exercises);
    called.add(particles::exercises_of_constraints(toy));
  }
  if (!scene.dense.empty()) called.add(std::array{"H10"});
  return called.take();
}

}  // namespace hair
