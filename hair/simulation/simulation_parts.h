// Which parts a simulation has. Those that call an exercise are there if the course has it; a description that
// needs one of the others throws std::invalid_argument.
#pragma once

#include "hair/simulation/simulation.h"

namespace hair {

StepMethod method_of(Method method);

// The forces that the description asks for, to a strand that was made of `start` (whose strand may be gone).
void add_forces(const Description& description, const StrandStart& start, MovingStrand& moving);

}  // namespace hair
