// SHA-256 (FIPS 180-4), with which a page's policy names the scripts that may run.
#pragma once

#include <string>

namespace hair {

std::string sha256_bytes(std::string text);  // 32 bytes

}  // namespace hair
