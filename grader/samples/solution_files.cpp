// STAFF ONLY.
#include "grader/samples/solution_files.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "grader/course/input.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

fs::path base_folder(const std::string& base, const fs::path& project) {
  if (base == "reference") return project / "reference";
  if (base == "stub") return project / "handout" / "student";
  return project / "grader" / "samples" / "solutions" / base;
}

// The program's exit code.
int run(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0) return 127;
  int status = 0;
  if (waitpid(child, &status, 0) != child || !WIFEXITED(status)) return 127;
  return WEXITSTATUS(status);
}

std::string as_on_windows(const std::string& text) {
  std::string windows = "\xEF\xBB\xBF";
  for (const char c : text) {
    if (c == '\n') windows += '\r';
    windows += c;
  }
  return windows;
}

}  // namespace

std::map<std::string, std::string> solution_files(const Sample& sample, const fs::path& project,
                                                  const fs::path& scratch) {
  fs::create_directories(scratch);
  for (const SampleFile& file : sample.files) {
    if (file.kind != SampleFile::Kind::solution) continue;
    const std::string name = fs::path(file.path).filename().string();
    const fs::path source = base_folder(file.value, project) / name;
    if (!fs::is_regular_file(source)) {
      throw BadInput("sample \"" + sample.name + "\": " + file.path + ": " + source.string() +
                     " is not there; name \"reference\", \"stub\" or a folder of solutions/ that has it");
    }
    write_bytes(scratch / name, read_bytes(source));
  }

  if (!sample.patch.empty()) {
    const fs::path patch = project / "grader" / "samples" / "patches" / sample.patch;
    // No fuzz: a patch that lands elsewhere makes another bug than the one that is listed.
    const int code = run({"patch", "--strip=1", "--batch", "--fuzz=0", "--silent", "--no-backup-if-mismatch",
                          "--directory=" + scratch.string(), "--input=" + fs::absolute(patch).string()});
    if (code == 127) throw BadInput("can't run patch; install the package patch");
    if (code != 0) {
      throw BadInput("sample \"" + sample.name + "\": " + patch.string() +
                     " does not apply; make it again for the files as they are now");
    }
  }

  std::map<std::string, std::string> texts;
  for (const SampleFile& file : sample.files) {
    if (file.kind != SampleFile::Kind::solution) continue;
    const std::string text = read_bytes(scratch / fs::path(file.path).filename());
    texts[file.path] = sample.windows ? as_on_windows(text) : text;
  }
  fs::remove_all(scratch);
  return texts;
}

std::string read_bytes(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (!in) throw std::runtime_error(file.string() + ": can't be read");
  return bytes;
}

void write_bytes(const fs::path& file, const std::string& bytes) {
  std::ofstream out(file, std::ios::binary);
  out << bytes;
  out.close();
  if (!out) throw std::runtime_error(file.string() + ": can't be written");
}

}  // namespace grader
