// STAFF ONLY. `hairgrade compare`: compares two pictures, or two folders of frames. It draws nothing, runs no
// student code and needs no secret.
#pragma once

#include <atomic>
#include <filesystem>
#include <iosfwd>
#include <optional>

namespace grader::inline tool {

struct CompareSettings {
  std::filesystem::path reference, test;
  std::optional<std::filesystem::path> out;  // is a folder for NAME-heat.png, NAME-side.png, index.html
  bool json = false;                         // on `output`, instead of the table
};

// Returns the exit code: 0, or 130 if `interrupted` was set. In two folders, unreadable pictures, pictures of
// different sizes and a picture that one folder lacks are named, ranked worst, and give 3. Throws BadInput
// before writing to `out`: as find_pairs does, for two pictures that can't be compared, and for a folder that
// can't be written.
int compare_pictures(const CompareSettings& settings, std::ostream& output,
                     const std::atomic<bool>& interrupted);

}  // namespace grader::tool
