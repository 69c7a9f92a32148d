// STAFF ONLY. A sample's exercise files: copies of the reference, the stubs or a whole solution, with the
// headers beside them inserted, and the sample's edits.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "grader/samples/sample.h"

namespace grader::inline samples {

// Returns files by path in the archive. `project` is the project's root. Throws BadInput if a file or an
// edit's lines are missing.
std::map<std::string, std::string> solution_files(const Sample& sample, const std::filesystem::path& project);

// Throws std::runtime_error with the path.
std::string read_bytes(const std::filesystem::path& file);
void write_bytes(const std::filesystem::path& file, const std::string& bytes);

}  // namespace grader::samples
