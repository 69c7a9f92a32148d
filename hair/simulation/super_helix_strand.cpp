#include "hair/simulation/super_helix_strand.h"

#include <stdexcept>

#include "hair/simulation/description.h"
#include "hair/super_helix/super_helix_body.h"

namespace hair {

std::vector<std::string> super_helix_exercises(const StrandSpec&) {
  return {"H8"};
}

std::string super_helix_why_not(const StrandSpec& spec) {
  return why_not_of_helices(spec);
}

long super_helix_points(const StrandSpec& spec) {
  return helix_points(spec);
}

bool super_helix_moves_by(const MethodRow& method) {
  return method.method == Method::implicit_euler;
}

std::unique_ptr<Body> make_super_helix(const StrandSpec& spec, const Description& description) {
  const MethodRow& method = row_of(description.method);
  if (!super_helix_moves_by(method))
    throw std::invalid_argument(std::string("super-helices don't move by ") + method.id + "; they do by " +
                                row_of(Method::implicit_euler).id);
  const HelixSurroundings surroundings{description.gravity, description.drag, description.wind,
                                       spec.fibre.relaxation_time};
  return std::make_unique<SuperHelixBody>(helix_start(spec), surroundings, spec.root_velocity);
}

}  // namespace hair
