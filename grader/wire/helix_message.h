// STAFF ONLY. Super-helices in a message: frames, strands, elements and points.
#pragma once

#include <vector>

#include "grader/wire/message.h"
#include "hair/helix.h"

namespace grader {

void put_vector3(MessageWriter& message, const hair::Vector3d& vector);
void put(MessageWriter& message, const hair::MaterialFrame& frame);
void put(MessageWriter& message, const hair::HelixJacobian& jacobian);
void put(MessageWriter& message, const hair::HelixStrand& strand);
void put(MessageWriter& message, const std::vector<hair::HelixElement>& elements);
void put(MessageWriter& message, const std::vector<hair::HelixPoint>& points);

// Each throws MalformedMessage for a message that is too short. Numbers may be anything.
hair::Vector3d get_vector3(MessageReader& message);
hair::MaterialFrame get_frame(MessageReader& message);
hair::HelixJacobian get_jacobian(MessageReader& message);
hair::HelixStrand get_helix_strand(MessageReader& message);  // also for another number of natural coordinates
std::vector<hair::HelixElement> get_elements(MessageReader& message);  // also for none
// Also for points of elements that are not there, and for another order than theirs.
std::vector<hair::HelixPoint> get_points(MessageReader& message, std::size_t elements);

}  // namespace grader
