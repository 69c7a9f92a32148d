// Which parts a simulation has. Those that call an exercise are there if the course has it; a description that
// needs one of the others throws std::invalid_argument.
#pragma once

#include "hair/simulation.h"

namespace hair {

StepMethod method_of(Method method);

// The forces that the description asks for. Its strands have been moved from.
void add_forces(const Description& description, MovingStrand& moving);

}  // namespace hair
