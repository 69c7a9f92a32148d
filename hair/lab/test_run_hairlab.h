// Runs hairlab as a user does.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "hair/io/files/read_file.h"
#include "hair/io/files/start_program.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace hair {

struct ProgramRun {
  int code = 0;  // the exit code; -1: a signal ended it
  std::string output, errors;
};

struct ProgramSettings {
  std::string program = HAIRLAB;
  std::vector<std::string> environment = {};  // "NAME=value", in addition to our own
  long file_limit = -1;                       // the largest file that it may write, in units of 512 bytes
  std::function<void(int)> meanwhile = {};    // called with its process id once it runs
  std::filesystem::path output = {};          // file for its standard output; empty: into the ProgramRun
};

ProgramRun run_hairlab(const std::vector<std::string>& arguments, const ProgramSettings& settings = {});

// Expects this exit code, no output, and one line of an error that has a part.
void expect_refused(const ProgramRun& run, int code, const std::string& part);

std::ptrdiff_t lines_of(const std::string& text);
using tests::says;

// A test's own folder; removed with this object.
class TestFolder {
 public:
  std::filesystem::path operator/(const std::string& name) const { return path() / name; }
  const std::filesystem::path& path() const { return folder_.path(); }
  std::vector<std::string> names(const std::string& folder = "") const;  // all of its files, in order

  // Writes a file, and returns its path.
  std::string write(const std::string& name, const std::string& bytes) const;

 private:
  TemporaryFolder folder_{"hairlab"};
};

}  // namespace hair
