#include "hair/lab/test_run_hairlab.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "hair/io/files/read_file.h"

namespace hair {

namespace fs = std::filesystem;

ProgramRun run_hairlab(const std::vector<std::string>& arguments, const ProgramSettings& settings) {
  const TestFolder folder;
  const fs::path output = settings.output.empty() ? folder / "output" : settings.output,
                 errors = folder / "errors";
  std::vector<std::string> words = {settings.program};
  if (settings.file_limit >= 0)
    words = {"/bin/sh", "-c", "ulimit -f " + std::to_string(settings.file_limit) + "; exec \"$0\" \"$@\"",
             settings.program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const pid_t process = start_program(
      {.words = words, .output = output, .errors = errors, .environment = settings.environment});
  if (settings.meanwhile) settings.meanwhile(process);
  const int code = exit_code_of(process).value_or(-1);
  return {code, settings.output.empty() ? bytes_of(output) : "", bytes_of(errors)};
}

void expect_refused(const ProgramRun& run, int code, const std::string& part) {
  EXPECT_EQ(run.code, code) << run.errors;
  EXPECT_TRUE(says(run.errors, part));
  EXPECT_EQ(lines_of(run.errors), 1) << run.errors;
  EXPECT_TRUE(run.errors.starts_with("hairlab: ")) << run.errors;
  EXPECT_EQ(run.output, "");
}

std::ptrdiff_t lines_of(const std::string& text) {
  return std::ranges::count(text, '\n');
}

std::vector<std::string> TestFolder::names(const std::string& folder) const {
  std::vector<std::string> all;
  for (const fs::directory_entry& entry : fs::directory_iterator(path() / folder))
    all.push_back(entry.path().filename().string());
  std::ranges::sort(all);
  return all;
}

std::string TestFolder::write(const std::string& name, const std::string& bytes) const {
  std::ofstream(path() / name, std::ios::binary) << bytes;
  return (path() / name).string();
}

}  // namespace hair
