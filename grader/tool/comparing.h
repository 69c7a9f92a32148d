// STAFF ONLY. `hairgrade compare`: two pictures, or two folders of frames. It draws nothing, runs nothing of
// a student's and needs no secret.
#pragma once

#include <atomic>
#include <filesystem>
#include <iosfwd>
#include <optional>

namespace grader {

struct CompareSettings {
  std::filesystem::path reference, test;
  std::optional<std::filesystem::path> out;  // a folder: NAME-heat.png, NAME-side.png, index.html
  bool json = false;                         // on `output`, in place of the table
};

// The exit code: 0, or 130 if `interrupted` was set meanwhile. Throws BadInput before anything is in `out`:
// what find_pairs throws, a picture that can't be read, sizes that differ, a folder that can't be written.
int compare(const CompareSettings& settings, std::ostream& output, const std::atomic<bool>& interrupted);

}  // namespace grader
