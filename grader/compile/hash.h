// STAFF ONLY. SHA-256 and HMAC-SHA-256 (FIPS 180-4, FIPS 198-1), in hexadecimal.
#pragma once

#include <filesystem>
#include <string>

namespace grader::inline compile {

std::string sha256(const std::string& bytes);
std::string hmac_sha256(const std::string& key, const std::string& bytes);

// Hashes a file's bytes, or a folder's files with their names. Throws BadInput for a path that can't be read.
std::string sha256_of(const std::filesystem::path& path);

}  // namespace grader::compile
