// STAFF ONLY. Finds files that samples leave outside of the sandbox; their names show it.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace grader {

// Searches `places`, and folders that everybody may write to.
inline std::vector<std::filesystem::path> traces(std::vector<std::filesystem::path> places) {
  namespace fs = std::filesystem;
  for (const char* place : {"/", "/tmp", "/var/tmp", "/dev/shm"}) places.emplace_back(place);
  places.push_back(fs::temp_directory_path());
  places.push_back(fs::current_path());
  if (const char* home = std::getenv("HOME")) places.emplace_back(home);

  std::vector<fs::path> found;
  for (const fs::path& place : places) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(place, error))
      if (entry.path().filename().string().find("hair-sample-was-here") != std::string::npos)
        found.push_back(entry.path());
  }
  return found;
}

}  // namespace grader
