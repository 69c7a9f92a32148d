#include "hair/io/files/start_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

extern char** environ;  // macOS's headers do not declare it

namespace hair {
namespace {

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> all;
  for (const std::string& word : words) all.push_back(const_cast<char*>(word.c_str()));
  all.push_back(nullptr);
  return all;
}

std::vector<std::string> ours_and(const std::vector<std::string>& theirs) {
  std::vector<std::string> all = theirs;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string ours = *variable, name = ours.substr(0, ours.find('=') + 1);
    if (std::none_of(theirs.begin(), theirs.end(),
                     [&](const std::string& one) { return one.starts_with(name); }))
      all.push_back(ours);
  }
  return all;
}

void add_stream(posix_spawn_file_actions_t& actions, int number, const Stream& stream) {
  if (const int* descriptor = std::get_if<int>(&stream))
    posix_spawn_file_actions_adddup2(&actions, *descriptor, number);
  else if (const auto* file = std::get_if<std::filesystem::path>(&stream))
    posix_spawn_file_actions_addopen(&actions, number, file->c_str(),
                                     number == 0 ? O_RDONLY : O_WRONLY | O_CREAT | O_TRUNC, 0644);
}

}  // namespace

pid_t start_program(const Program& program) {
  const std::vector<std::string> environment = ours_and(program.environment);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  add_stream(actions, 0, program.input);
  add_stream(actions, 1, program.output);
  add_stream(actions, 2, program.errors);
  if (!program.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, program.folder.c_str());
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  if (program.leads_group) posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t process = 0;
  const int error = posix_spawn(&process, program.words.at(0).c_str(), &actions, &attributes,
                                pointers(program.words).data(), pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) throw std::system_error(error, std::generic_category(), program.words[0]);
  return process;
}

bool wait_until(const std::function<bool()>& happened, pid_t process) {
  for (bool ended = false; !happened(); std::this_thread::sleep_for(std::chrono::milliseconds(1))) {
    if (ended) return false;
    siginfo_t end{};
    if (waitid(P_PID, static_cast<id_t>(process), &end, WEXITED | WNOHANG | WNOWAIT) != 0)
      throw std::system_error(errno, std::generic_category(), "waitid");
    ended = end.si_pid == process;
  }
  return true;
}

std::optional<int> exit_code_of(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0)
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
  if (!WIFEXITED(status)) return {};
  return WEXITSTATUS(status);
}

}  // namespace hair

#ifdef __APPLE__
#include <mach-o/dyld.h>

#include <array>
#endif

namespace hair {

std::filesystem::path this_program() {
#ifdef __APPLE__
  std::array<char, 4096> path;
  uint32_t size = path.size();
  if (_NSGetExecutablePath(path.data(), &size) == 0) return path.data();
#endif
  return "/proc/self/exe";
}

}  // namespace hair
