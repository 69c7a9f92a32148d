// STAFF ONLY. Bytes as text, for pages and JSON.
#pragma once

#include <string>
#include <string_view>

#include "hair/io/files/base64.h"

namespace grader::inline result {

using hair::base64;

// Decodes the text. Throws std::invalid_argument for text that base64() can't produce.
std::string from_base64(std::string_view text);

}  // namespace grader::result
