// STAFF ONLY. From an address in a student's object to a line of the student's file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/compile/toolchain.h"

namespace grader {

// The line of `file` that the first of `offsets` belongs to that belongs to any: those before it may be in the headers that
// the file includes. The object was linked for Build::sanitised, and nobody trusts it: binutils read it in
// a cage, and only a number comes out, from 1 to `lines`. Nothing if there is none.
std::optional<int> line_of(const Toolchain& toolchain, const std::filesystem::path& object,
                           const std::string& file, int lines, const std::vector<std::uint64_t>& offsets);

}  // namespace grader
