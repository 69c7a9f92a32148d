#include "hair/lab/run/film.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>
#include <vector>

#include "hair/io/files/printable.h"

extern char** environ;

namespace hair {

namespace fs = std::filesystem;

namespace {

constexpr const char* kErrors = "film.errors";

std::string digits_of(double number) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

// What a program that runs in `folder` returned, or nothing if it could not be started or a signal ended it.
std::optional<int> run_program(const fs::path& program, std::vector<std::string> arguments,
                               const fs::path& folder) {
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, 2, kErrors, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  pid_t process = 0;
  const int error = posix_spawn(&process, program.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return {};
  int status = 0;
  while (waitpid(process, &status, 0) < 0)
    if (errno != EINTR) return {};
  if (!WIFEXITED(status)) return {};
  return WEXITSTATUS(status);
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
  // One thread and no dates: the same pictures give the same bytes. Most players want an even number of rows
  // and columns, and colours at half their resolution.
  const auto code = run_program(*program,
                                {"ffmpeg",
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
                                 "film.mp4"},
                                folder);
  const std::string line = first_line(errors);
  std::error_code ignored;
  fs::remove(errors, ignored);
  if (code == 0 && fs::exists(film, ignored)) return {};
  fs::remove(film, ignored);
  return "ffmpeg failed (" + (code ? "exit code " + std::to_string(*code) : "it was ended from outside") +
         (line.empty() ? "" : ": " + line) + "); the pictures are there";
}

}  // namespace hair
