// STAFF ONLY. A strand in a message, and the vectors of its particles.
#pragma once

#include "grader/wire/message.h"
#include "hair/strand.h"

namespace grader {

void put(MessageWriter& message, const Eigen::VectorXd& vector);
Eigen::VectorXd get_vector(MessageReader& message,
                           Eigen::Index expected);  // MalformedMessage for another length

void put(MessageWriter& message, const hair::Strand& strand);

// Throws MalformedMessage if there are no particles, or if the number of segments is not one less. Numbers
// may be anything: callers that need finite or positive numbers must check.
hair::Strand get_strand(MessageReader& message);

}  // namespace grader
