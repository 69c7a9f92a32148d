// STAFF ONLY. Writes bytes as text, for pages and JSON: base64 with padding (RFC 4648, section 4).
#pragma once

#include <string>
#include <string_view>

namespace grader::inline result {

std::string base64(std::string_view bytes);

// Decodes the text. Throws std::invalid_argument for text that base64() can't produce.
std::string from_base64(std::string_view text);

}  // namespace grader::result
