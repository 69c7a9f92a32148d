// STAFF ONLY. A strand in a message, and the vectors of its particles.
#pragma once

#include "grader/wire/message.h"
#include "hair/strand.h"

namespace grader {

void put(MessageWriter& message, const Eigen::VectorXd& vector);
Eigen::VectorXd get_vector(MessageReader& message,
                           Eigen::Index expected);  // MalformedMessage for another length

void put(MessageWriter& message, const hair::Strand& strand);

// Throws MalformedMessage for what has no particles, or not one segment less than it has particles. Numbers
// may be anything: whoever needs them finite or positive looks for himself.
hair::Strand get_strand(MessageReader& message);

}  // namespace grader
