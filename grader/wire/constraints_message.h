// STAFF ONLY. Constraints in a message.
#pragma once

#include "grader/wire/message.h"
#include "particles/constraint_forces.h"

namespace grader {

void put(MessageWriter& message, const particles::Constraints& constraints);
particles::Constraints get_constraints(MessageReader& message);

}  // namespace grader
