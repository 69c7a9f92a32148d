// Makes a film of a run's pictures with the program ffmpeg, if it is installed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace hair {

// Makes film.mp4 of the folder's frame-0000.png, frame-0001.png, ... Returns nothing on success. On failure
// it returns one sentence with the reason, and leaves no partial file.
std::optional<std::string> make_film(const std::filesystem::path& folder, double frames_per_second);

// The path of ffmpeg from PATH, or nothing.
std::optional<std::filesystem::path> find_ffmpeg();

}  // namespace hair
