// A film of a run's pictures, by the program ffmpeg where there is one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace hair {

// Makes film.mp4 of the folder's frame-0000.png, frame-0001.png, ... Nothing, or one sentence that says why
// there is no film; then there is no part of one, either.
std::optional<std::string> make_film(const std::filesystem::path& folder, double frames_per_second);

// ffmpeg on PATH, or nothing.
std::optional<std::filesystem::path> find_ffmpeg();

}  // namespace hair
