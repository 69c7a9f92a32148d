// STAFF ONLY. A precompiled header of the Eigen headers that every exercise with Eigen includes. It saves
// half of such a file's compile time. The object is bit-identical.
//
// GCC uses a precompiled header if compiler and options are the same as for its creation; otherwise it
// silently reads the text. So it makes a file fail in only one case: if the file defines a macro for Eigen,
// the definition comes too late. The caller therefore compiles a failing file once more without it.
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "grader/compile/toolchain.h"

namespace grader::inline compile {

class PrecompiledHeader {
 public:
  PrecompiledHeader(const Toolchain& toolchain, std::filesystem::path cache)
      : toolchain_(toolchain), cache_(std::move(cache)) {}

  // Mounts it for exercises with these libraries, and adds the option to use it. Makes it at the first use if
  // it is not in the cache. Returns false, and changes nothing, if the exercise can't use it.
  bool use(const std::vector<std::string>& libraries, Sandbox& sandbox,
           std::vector<std::string>& command) const;

 private:
  void make() const;
  std::optional<std::string> compile() const;

  const Toolchain& toolchain_;
  std::filesystem::path cache_;
  mutable std::once_flag made_;
  mutable std::filesystem::path folder_;  // empty: making it failed
};

}  // namespace grader::compile
