// STAFF ONLY. Particles and their state in a message.
#pragma once

#include "grader/wire/message.h"
#include "particles/state.h"

namespace grader {

void put(MessageWriter& message, const particles::Particles& particles);
particles::Particles get_particles(MessageReader& message);

void put(MessageWriter& message, const particles::State& state);
particles::State get_state(MessageReader& message, int n);  // of n particles; else throws MalformedMessage

}  // namespace grader
