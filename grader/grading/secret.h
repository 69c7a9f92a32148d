// STAFF ONLY. The staff's secret; every student's inputs are derived from it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace grader::inline grading {

// Returns ~/.config/hairgrade/secret. Throws BadInput if there is no home.
std::filesystem::path default_secret_file();

// Returns the content of `file`, or of the default file, which is made at the first use. Throws BadInput for
// a file that can't be read or has fewer than 16 bytes.
std::string read_secret(const std::optional<std::filesystem::path>& file);

// Writes a secret into a new file that its owner alone can read. Returns false if the file exists. Throws
// BadInput if it can't be written.
bool keep_secret(const std::string& secret, const std::filesystem::path& file);

// Returns sixteen hexadecimal digits that only distinguish secrets: an HMAC whose key is the secret. Records
// keep it.
std::string fingerprint(const std::string& secret);

// Both write a file that its owner alone can read, in full or not at all, and replace none: they throw
// BadInput if `file`, or another secret, is there. The default secret is exported; an imported one becomes
// the default. They return its fingerprint.
std::string export_secret(const std::filesystem::path& file);
std::string import_secret(const std::filesystem::path& file);

// Returns the seed of a student's inputs for an exercise. It stays the same when the student hands in again.
std::string seed_for(const std::string& secret, const std::string& student, const std::string& exercise);

}  // namespace grader::grading
