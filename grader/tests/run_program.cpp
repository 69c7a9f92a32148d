// STAFF ONLY. Starts hairgrade and reads both of its streams.
#include "grader/tests/run_program.h"

#include <spawn.h>
#include <sys/wait.h>

#include <cstdlib>
#include <iostream>
#include <system_error>
#include <thread>

#include "grader/sandbox/descriptor.h"

extern char** environ;

namespace grader {

ProgramRun run_hairgrade(const std::vector<std::string>& arguments,
                         const std::function<void(int)>& meanwhile) {
  Pipe out = make_pipe(), errors = make_pipe();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, out.write_end.get(), 1);
  posix_spawn_file_actions_adddup2(&actions, errors.write_end.get(), 2);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  if (meanwhile) posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);  // a new one
  std::vector<std::string> words = {HAIRGRADE};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t process = 0;
  const int error = posix_spawn(&process, argv[0], &actions, &attributes, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) throw std::system_error(error, std::generic_category(), HAIRGRADE);
  out.write_end.close();
  errors.write_end.close();

  ProgramRun run;
  std::jthread reader([&] { run.errors = read_all(errors.read_end, 1 << 20, 600); });
  if (meanwhile) meanwhile(process);
  run.output = read_all(out.read_end, 1 << 20, 600);
  reader.join();
  int status = 0;
  waitpid(process, &status, 0);
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  // Not bad input, but something that went wrong: a test that fails of it says what.
  if (run.code == 1 || run.code == -1)
    std::cout << HAIRGRADE << " ended with " << run.code << ": " << run.errors << "\n";
  return run;
}

std::string environment(const char* name, const std::string& otherwise) {
  const char* value = std::getenv(name);
  return value ? value : otherwise;
}

}  // namespace grader
