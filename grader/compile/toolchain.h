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
    std::string output;  // its beginning
  };

  // Runs a command, which speaks of `file`. Throws std::runtime_error if it is the machine that fails.
  Run run(const Cage& cage, const std::vector<std::string>& command, const std::string& file) const;

  // A cage with the given headers and those of the libraries, and the command to compile in it. Missing are what
  // is compiled, where to, and the mounts for both.
  Cage compiling(const std::vector<std::string>& libraries) const;
  std::vector<std::string> compile_command(const std::vector<std::string>& libraries) const;

  // The same for linking: a cage with neither.
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

// A new folder in which the sandbox's user may write.
std::filesystem::path writable_folder(const std::filesystem::path& path);

// What a tool wrote there; nothing if that is no plain file, or larger than `most`. Not through a link, which it
// could have left.
std::optional<std::string> read_written(const std::filesystem::path& path, std::size_t most);

}  // namespace grader
