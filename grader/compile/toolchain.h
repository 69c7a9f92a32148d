// STAFF ONLY. The system's compiler and linker, run in cages.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/compile/kit.h"
#include "grader/sandbox/cage.h"

namespace grader {

class Toolchain {
 public:
  // Throws BadInput if there is no compiler.
  Toolchain(const StagedKit& kit, bool isolated);

  struct Run {
    Ending ending;
    std::string output;  // the beginning of the output
  };

  // Runs a command about `file`. Throws std::runtime_error if the machine fails.
  Run run(const Cage& cage, const std::vector<std::string>& command, const std::string& file) const;

  // A cage with the given headers and the libraries' headers, and the command to compile in it. The caller
  // adds the input, the output, and the mounts for both.
  Cage compiling(const std::vector<std::string>& libraries) const;
  std::vector<std::string> compile_command(const std::vector<std::string>& libraries) const;

  // The same for linking: a cage without headers.
  Cage linking() const;
  std::vector<std::string> link_command() const;

  const StagedKit& kit() const { return kit_; }
  bool isolated() const { return isolated_; }
  const std::string& version() const { return version_; }  // changes with the compiler and its options

 private:
  const StagedKit& kit_;
  bool isolated_;
  std::string program_, version_;
};

// A new folder that the sandbox's user may write to.
std::filesystem::path writable_folder(const std::filesystem::path& path);

// Reads a tool's output file; nothing if it is not a plain file, or larger than `most`. Does not follow
// links, because the tool could have left one.
std::optional<std::string> read_written(const std::filesystem::path& path, std::size_t most);

}  // namespace grader
