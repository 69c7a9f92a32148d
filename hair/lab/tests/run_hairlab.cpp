#include "hair/lab/tests/run_hairlab.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>

extern char** environ;

namespace hair {

namespace fs = std::filesystem;

namespace {

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

}  // namespace

ProgramRun run_hairlab(const std::vector<std::string>& arguments, const ProgramSettings& settings) {
  const TestFolder folder;
  const std::string output = (folder / "output").string(), errors = (folder / "errors").string();
  std::vector<std::string> words = {settings.program};
  if (settings.file_limit >= 0)
    words = {"/bin/sh", "-c", "ulimit -f " + std::to_string(settings.file_limit) + "; exec \"$0\" \"$@\"",
             settings.program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = settings.environment;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string ours = *variable, name = ours.substr(0, ours.find('=') + 1);
    if (std::none_of(settings.environment.begin(), settings.environment.end(),
                     [&](const std::string& theirs) { return theirs.starts_with(name); }))
      environment.push_back(ours);
  }

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, output.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, 2, errors.c_str(), O_WRONLY | O_CREAT, 0600);
  pid_t process = 0;
  const int error = posix_spawn(&process, words[0].c_str(), &actions, nullptr, pointers(words).data(),
                                pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::system_error(error, std::generic_category(), words[0]);
  if (settings.meanwhile) settings.meanwhile(process);
  int status = 0;
  waitpid(process, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_bytes(output), read_bytes(errors)};
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::ptrdiff_t lines_of(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

std::string read_bytes(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> TestFolder::names(const std::string& folder) const {
  std::vector<std::string> all;
  for (const fs::directory_entry& entry : fs::directory_iterator(path() / folder))
    all.push_back(entry.path().filename().string());
  std::sort(all.begin(), all.end());
  return all;
}

std::string TestFolder::write(const std::string& name, const std::string& bytes) const {
  std::ofstream(path() / name, std::ios::binary) << bytes;
  return (path() / name).string();
}

}  // namespace hair
