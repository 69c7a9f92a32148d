#include "hair/lab/run/film.h"

#include <unistd.h>

#include <array>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>
#include <vector>

#include "hair/io/files/printable.h"
#include "hair/io/files/start_program.h"

namespace hair {

namespace fs = std::filesystem;

namespace {

constexpr const char* kErrors = "film.errors";

std::string digits_of(double number) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

std::string first_line(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return printable(line);
}

}  // namespace

std::optional<fs::path> find_ffmpeg() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  std::error_code ignored;
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path program = fs::path(folder.empty() ? "." : folder) / "ffmpeg";
    if (access(program.c_str(), X_OK) == 0 && fs::is_regular_file(program, ignored))
      return fs::absolute(program);
  }
  return {};
}

std::optional<std::string> make_film(const fs::path& folder, double frames_per_second) {
  const auto program = find_ffmpeg();
  if (!program) return "ffmpeg is not on PATH (package ffmpeg brings it)";
  const fs::path film = folder / "film.mp4", errors = folder / kErrors;
  // One thread and no dates: the same pictures give the same bytes. Most video runners need an even number of
  // rows and columns, and colours at half their resolution.
  const std::vector<std::string> words = {program->string(),
                                          "-nostdin",
                                          "-loglevel",
                                          "error",
                                          "-y",
                                          "-framerate",
                                          digits_of(frames_per_second),
                                          "-i",
                                          "frame-%04d.png",
                                          "-vf",
                                          "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                          "-pix_fmt",
                                          "yuv420p",
                                          "-threads",
                                          "1",
                                          "-fflags",
                                          "+bitexact",
                                          "-flags:v",
                                          "+bitexact",
                                          "-movflags",
                                          "+faststart",
                                          "film.mp4"};
  std::optional<int> code;
  try {
    code = exit_code_of(start_program({.words = words,
                                       .input = fs::path("/dev/null"),
                                       .output = fs::path("/dev/null"),
                                       .errors = errors,
                                       .folder = folder}));
  } catch (const std::system_error& error) {
    return "ffmpeg can't be started (" + error.code().message() + "); the pictures are there";
  }
  const std::string line = first_line(errors);
  std::error_code ignored;
  fs::remove(errors, ignored);
  if (code == 0 && fs::exists(film, ignored)) return {};
  fs::remove(film, ignored);
  return "ffmpeg failed (" + (code ? "exit code " + std::to_string(*code) : "it was ended from outside") +
         (line.empty() ? "" : ": " + line) + "); the pictures are there";
}

}  // namespace hair
