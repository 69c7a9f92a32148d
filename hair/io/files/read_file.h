// Reads all bytes of a file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace hair {

// Throws BadInput for a file that can't be read, is a folder, or has more than `most` bytes; never reads more
// bytes than that. `wanted` ends the sentence "give the path of ...": "a JSON file".
std::string read_file(const std::filesystem::path& file, std::size_t most, const std::string& wanted);

// The bytes of a file of our own; empty if it can't be read.
std::string bytes_of(const std::filesystem::path& file);

}  // namespace hair
