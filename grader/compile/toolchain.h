// STAFF ONLY. The system's compiler and linker, run in sandboxes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/course/course.h"
#include "grader/sandbox/processes/identity.h"
#include "grader/sandbox/sandbox.h"

namespace grader::inline compile {

// A copy of the grading kit (see grader/worker/CMakeLists.txt) in a folder that only the
// sandbox's user can read. The original can't be mounted directly if the clone is under /root.
class StagedKit {
 public:
  // Throws BadInput if the kit is missing or incomplete.
  StagedKit(const std::filesystem::path& kit, const Course& course);
  StagedKit(const StagedKit&) = delete;
  StagedKit& operator=(const StagedKit&) = delete;

  std::filesystem::path folder() const { return root_.path() / "kit"; }
  std::filesystem::path empty_folder() const { return root_.path() / "empty"; }
  std::filesystem::path roots() const {
    return root_.path() / "roots";
  }  // see grader/sandbox/container_root.h

  // Makes a new folder beside it for one job; the sandbox's user can read it.
  std::filesystem::path new_job(const std::string& name) const;

  // Changes with every file that student code is compiled against or run by.
  const std::string& hash() const { return hash_; }

 private:
  StagingFolder root_;
  std::string hash_;
};

// The sandbox that compiles has student/ beside the contracts' folders, as at home.
inline constexpr const char* kStudentFolder = "/handout/student";

class Toolchain {
 public:
  // Throws BadInput if there is no compiler.
  Toolchain(const StagedKit& kit, Isolation isolation);

  struct Run {
    Ending ending;
    std::string output;      // is its beginning and its end
    double cpu_seconds = 0;  // sums compiler, assembler and linker
    bool limited = false;    // it met a limit, and would meet it again
  };

  // Runs a command about `file`.
  Run run(const Sandbox& sandbox, const std::vector<std::string>& command, const std::string& file) const;

  // Finds whose fault a failed command is: runs the same tools in the same sandbox without a student's file.
  // Throws std::runtime_error, our fault, if that fails, too. The tools' messages decide nothing, since a
  // student's file can choose them.
  void prove_it_compiles(const Sandbox& sandbox) const;
  void prove_it_links(const Sandbox& sandbox) const;

  // Returns a sandbox for `cpu_seconds` of all tools, with the given headers and the libraries' headers, and
  // the command to compile in it. The caller adds the input, the output, and the mounts for both.
  Sandbox compiling(const std::vector<std::string>& libraries, double cpu_seconds) const;
  std::vector<std::string> compile_command(const std::vector<std::string>& libraries) const;

  // Adds `in`, where it runs, and `out`, where it writes.
  Sandbox compiling(const std::vector<std::string>& libraries, double cpu_seconds,
                    const std::filesystem::path& in, const std::filesystem::path& out) const;
  // Returns the same for linking: a sandbox without headers.
  Sandbox linking(double cpu_seconds) const;
  std::vector<std::string> link_command() const;

  const StagedKit& kit() const { return kit_; }
  bool isolated() const { return isolation_ != Isolation::none; }
  const std::string& version() const { return version_; }  // changes with the compiler and its options

 private:
  void prove(Sandbox sandbox, const std::vector<std::string>& command) const;

  const StagedKit& kit_;
  Isolation isolation_;
  std::string program_, version_;
  std::vector<Mount> system_;  // has compiler and linker
};

// Makes a folder with this file, for the sandbox's user. The file's date makes __TIMESTAMP__ constant.
std::filesystem::path source_folder(const std::filesystem::path& path, const std::string& name,
                                    const std::string& text);

// Makes a folder that the sandbox's user may write to.
std::filesystem::path writable_folder(const std::filesystem::path& path);

// Reads a tool's output file; nothing if it is not a plain file, or larger than `most`. Does not follow
// links, because the tool could have left one.
std::optional<std::string> read_written(const std::filesystem::path& path, std::size_t most);

}  // namespace grader::compile
