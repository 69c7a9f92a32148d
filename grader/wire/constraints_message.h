// STAFF ONLY. Constraints and particles in a message.
#pragma once

#include "grader/wire/message.h"
#include "particles/constraint_forces.h"

namespace grader {

void put(MessageWriter& message, const particles::Constraints& constraints);
particles::Constraints get_constraints(MessageReader& message);

void put(MessageWriter& message, const particles::Particles& particles);
particles::Particles get_particles(MessageReader& message);

}  // namespace grader
