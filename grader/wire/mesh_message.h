// STAFF ONLY. Links and strips in a message, for H9.
#pragma once

#include <span>
#include <vector>

#include "grader/wire/message.h"
#include "hair/static_links.h"

namespace grader {

void put(MessageWriter& message, const hair::StaticLink& link);
void put(MessageWriter& message, std::span<const hair::StaticLink> links);
void put(MessageWriter& message, std::span<const hair::Matrix3d> frames);
void put(MessageWriter& message, const hair::StripLaw& law);
void put(MessageWriter& message, const hair::StripContact& contact);
void put(MessageWriter& message, std::span<const hair::StripContact> contacts);

// Each throws MalformedMessage for a message that is too short, or for more than a message can hold. Numbers may be anything.
hair::StaticLink get_static_link(MessageReader& message);
std::vector<hair::StaticLink> get_static_links(MessageReader& message);
std::vector<hair::Matrix3d> get_particle_frames(MessageReader& message);
hair::StripLaw get_strip_law(MessageReader& message);
hair::StripContact get_strip_contact(MessageReader& message);
std::vector<hair::StripContact> get_strip_contacts(MessageReader& message);

}  // namespace grader
