// Bytes as text (RFC 4648, section 4), and their digest.
#pragma once

#include <string>

namespace hair {

std::string base64(const std::string& bytes);

// SHA-256 (FIPS 180-4), 32 bytes: a page's policy names the scripts that may run by it.
std::string sha256_bytes(std::string text);

}  // namespace hair
