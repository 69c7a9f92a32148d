#include <stdexcept>
#include <string>

#include "hair/simulation/models.h"
#include "hair/super_helix/super_helix_body.h"

namespace hair {

namespace {

constexpr Method kHelixMethod = Method::implicit_euler;

std::unique_ptr<Body> make_helix(const StrandSpec& spec, const Description& description) {
  if (description.method != kHelixMethod)
    throw std::invalid_argument(std::string("super-helices don't move by ") + row_of(description.method).id +
                                "; they do by " + row_of(kHelixMethod).id);
  const HelixSurroundings surroundings{description.gravity, description.drag, description.wind,
                                       spec.fibre.relaxation_time};
  return std::make_unique<SuperHelixBody>(helix_start(spec), surroundings, spec.root_velocity,
                                          description.watched);
}

}  // namespace

// Curvatures: the root's position, m, the turn of its frame, rad, and for each element two curvatures and the
// torsion, 1/m.
ModelRow super_helix_model() {
  return {.id = "super_helix",
          .coordinates = 2,
          .exercises = [](const StrandSpec&) { return std::vector<std::string>{"H8"}; },
          .calls_method = false,
          .usual_method = kHelixMethod,
          .why_not = why_not_of_helices,
          .points = helix_points,
          .make = make_helix,
          .moves_by = [](const MethodRow& row) { return row.method() == kHelixMethod; }};
}

}  // namespace hair
