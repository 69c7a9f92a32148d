// STAFF ONLY. Links of a tree and what the passes find of them, in a message.
#pragma once

#include <vector>

#include "grader/wire/message.h"
#include "hair/link.h"

namespace grader {

void put(MessageWriter& message, const std::vector<hair::Link>& links);
void put(MessageWriter& message, const std::vector<hair::LinkPass>& passes);

// Throws MalformedMessage for a message that is too short, for links whose parents don't come before them, and for
// unknown types of joints. `rates` becomes the number of all joints' rates. Numbers may be anything.
std::vector<hair::Link> get_links(MessageReader& message, int& rates);

// As many as `links`; MalformedMessage for another number.
std::vector<hair::LinkPass> get_passes(MessageReader& message, std::size_t links);

}  // namespace grader
