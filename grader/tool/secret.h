// STAFF ONLY. The staff's secret; every student's inputs are derived from it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace grader {

// The content of `file`, or of ~/.config/hairgrade/secret, which is made at the first use. Throws BadInput
// for a file that can't be read or has fewer than 16 bytes.
std::string read_secret(const std::optional<std::filesystem::path>& file);

// The seed of a student's inputs for an exercise. It stays the same when the student hands in again.
std::string seed_for(const std::string& secret, const std::string& student, const std::string& exercise);

}  // namespace grader
