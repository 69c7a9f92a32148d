#include "hair/simulation/mass_spring_strand.h"

namespace hair {

std::unique_ptr<MassSpringBody> mass_spring_strand(const std::string& name, const StrandStart& start,
                                                   const Description& description) {
  check_start(name, start);
  const ForceOptions options{description.geometric_term.value_or(row_of(description.method).usual_term()),
                             description.bend_product,
                             description.gravity,
                             description.drag,
                             description.wind,
                             description.point_forces,
                             description.preconditioner};
  return std::make_unique<MassSpringBody>(start, mass_spring_step(description.method), options,
                                          !description.obstacles.empty(), description.watched);
}

}  // namespace hair
