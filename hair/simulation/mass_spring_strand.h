// Makes a strand of masses and springs with a description's method and forces.
#pragma once

#include <memory>
#include <string>

#include "hair/mass_spring/mass_spring_body.h"
#include "hair/simulation/description.h"

namespace hair {

// Throws std::invalid_argument for a start that is out of bounds (`name` is in the message).
std::unique_ptr<MassSpringBody> mass_spring_strand(const std::string& name, const StrandStart& start,
                                                   const Description& description);

}  // namespace hair
