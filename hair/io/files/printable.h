// Names and text from outside as one line that can do nothing to a terminal.
#pragma once

#include <string>
#include <string_view>

namespace hair {

// Control characters, bytes outside ASCII and the backslash as \xNN; more than `most` bytes are cut and end
// with "...".
std::string printable(std::string_view bytes, std::size_t most = 200);

}  // namespace hair
