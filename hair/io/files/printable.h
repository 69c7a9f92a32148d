// Untrusted names and text as one line that is safe to print on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace hair {

// Writes control characters, bytes outside ASCII and the backslash as \xNN. Cuts more than `most` bytes and
// ends them with "...".
std::string printable(std::string_view bytes, std::size_t most = 200);

}  // namespace hair
