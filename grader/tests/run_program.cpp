// STAFF ONLY. Starts hairgrade and reads both of its streams.
#include "grader/tests/run_program.h"

#include <cstdlib>
#include <iostream>
#include <thread>

#include "grader/sandbox/descriptor.h"
#include "hair/io/files/start_program.h"

namespace grader {

ProgramRun run_hairgrade(const std::vector<std::string>& arguments,
                         const std::function<void(int)>& meanwhile) {
  Pipe out = make_pipe(), errors = make_pipe();
  std::vector<std::string> words = {HAIRGRADE};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const pid_t process = hair::start_program({.words = words,
                                             .output = out.write_end.get(),
                                             .errors = errors.write_end.get(),
                                             .leads_group = static_cast<bool>(meanwhile)});
  out.write_end.close();
  errors.write_end.close();

  ProgramRun run;
  std::jthread reader([&] { run.errors = read_all(errors.read_end, 1 << 20, 600); });
  if (meanwhile) meanwhile(process);
  run.output = read_all(out.read_end, 1 << 20, 600);
  reader.join();
  run.code = hair::exit_code_of(process).value_or(-1);
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
