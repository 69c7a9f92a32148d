// Bytes as text: RFC 4648, section 4.
#pragma once

#include <string>

namespace hair {

std::string base64(const std::string& bytes);

}  // namespace hair
