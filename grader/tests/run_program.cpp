// STAFF ONLY. Starts hairgrade and reads both of its streams.
#include "grader/tests/run_program.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <thread>

#include "grader/course/course.h"
#include "grader/record/record.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/start_program.h"
#include "hair/io/files/temporary_folder.h"

namespace grader {

namespace fs = std::filesystem;

bool RunningProgram::wait_until(const std::function<bool()>& happened) const {
  return hair::wait_until(happened, process);
}

namespace {

// Removes lines about the project's folders, whose modes concern no test.
std::string without_places_open_to_others(std::string errors) {
  const std::size_t begin = errors.find("hairgrade: others on this machine can read ");
  if (begin != std::string::npos) errors.erase(begin, errors.find('\n', begin) + 1 - begin);
  return errors;
}

}  // namespace

ProgramRun run_hairgrade(const std::vector<std::string>& arguments,
                         const std::function<void(const RunningProgram&)>& meanwhile,
                         const std::string& script) {
  const hair::TemporaryFolder temporary{"hairgrade"};
  const fs::path output = temporary.path() / "output", errors = temporary.path() / "errors";
  std::vector<std::string> words;
  if (!script.empty()) words = {"/usr/bin/bash", "-c", script + "\nexec \"$0\" \"$@\""};
  words.emplace_back(HAIRGRADE);
  words.insert(words.end(), arguments.begin(), arguments.end());
  const pid_t process = hair::start_program(
      {.words = words, .output = output, .errors = errors, .leads_group = static_cast<bool>(meanwhile)});
  if (meanwhile) meanwhile({process});
  const int code = hair::exit_code_of(process).value_or(-1);
  ProgramRun run{code, hair::bytes_of(output), without_places_open_to_others(hair::bytes_of(errors))};
  // Codes 1 and -1 are faults of the program: a failing test shows its errors.
  if (run.code == 1 || run.code == -1)
    std::cout << HAIRGRADE << " ended with " << run.code << ": " << run.errors << "\n";
  return run;
}

nlohmann::json course_of(const std::vector<std::string>& ids) {
  nlohmann::json roles;
  for (const Exercise& exercise : read_course(fs::path(HAIR_PROJECT) / "handout/exercises.json").exercises)
    if (std::ranges::count(ids, exercise.id) == 0) roles[exercise.id] = {{"role", "given"}};
  return {{"exercises", roles}};
}

std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && !entry.path().filename().string().starts_with(kRecordFile))
      all[fs::relative(entry.path(), folder).string()] = hair::bytes_of(entry.path());
  return all;
}

std::string sample(const std::string& name) {
  for (const char* ending : {"", ".zip", ".tar.gz"})
    if (const fs::path path = fs::path(HAIR_SAMPLE_CLASS) / (name + ending); fs::exists(path)) return path;
  throw std::runtime_error("the sample class has no " + name);
}

std::vector<fs::path> traces(std::vector<fs::path> places) {
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

void side_by_side(std::size_t count, const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::jthread> threads;
  for (unsigned t = 0; t < std::max(1u, std::thread::hardware_concurrency()); ++t)
    threads.emplace_back([&] {
      for (std::size_t i = next++; i < count; i = next++) body(i);
    });
}

std::string environment(const char* name, const std::string& otherwise) {
  const char* value = std::getenv(name);
  return value ? value : otherwise;
}

}  // namespace grader
