// STAFF ONLY. What every exercise with Eigen includes, read by the compiler once and not for each file: half of
// the time that such a file takes. The object is the same, bit by bit.
//
// GCC takes a precompiled header in place of its text if compiler and options are those that made it, and else,
// without a word, the text. So a file can fail for it in one way only: by a macro that it defines for Eigen,
// which comes too late. Whoever compiles with it compiles what fails once more without.
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "grader/compile/toolchain.h"

namespace grader {

class PrecompiledHeader {
 public:
  PrecompiledHeader(const Toolchain& toolchain, std::filesystem::path cache)
      : toolchain_(toolchain), cache_(std::move(cache)) {}

  // Mounts it for exercises with these libraries, and adds the option that uses it. Makes it when it is needed
  // for the first time and not in the cache. False, and nothing changed, if the exercise has no use for it.
  bool use(const std::vector<std::string>& libraries, Cage& cage, std::vector<std::string>& command) const;

 private:
  void make() const;
  std::optional<std::string> compile() const;

  const Toolchain& toolchain_;
  std::filesystem::path cache_;
  mutable std::once_flag made_;
  mutable std::filesystem::path folder_;  // empty: it can't be made
};

}  // namespace grader
