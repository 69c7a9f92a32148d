// STAFF ONLY. Compiles a student's file to a shared object that exports only the exercise's functions.
//
// The file is compiled in a sandbox with the file, the given headers and the system's compiler; it is linked
// in another sandbox with the object and the prerequisites' shared objects. Objects are cached by a hash of
// all their inputs: of threads that want the same one, the first makes it, and the others take it from the
// cache. A file that does not compile is compiled by each thread in turn. Without a sandbox nothing is kept.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "grader/compile/toolchain.h"
#include "grader/course/course.h"

namespace grader::inline compile {

// A precompiled header of the Eigen headers that every exercise with Eigen includes. It saves half of such a
// file's compile time. The object is bit-identical.
//
// GCC uses a precompiled header if compiler and options are the same as for its creation; otherwise it
// silently reads the text. So it makes a file fail in only one case: if the file defines a macro for Eigen,
// the definition comes too late. The caller therefore compiles a failing file once more without it.
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

struct Compiled {
  std::filesystem::path object;  // empty: it did not compile
  std::string messages;          // for the student: messages on the student's own lines
  std::string log;               // for staff: the whole output of compiler and linker
  double cpu_seconds = 0;        // is the time of this call; 0 if the object was cached
  double made_in_seconds = 0;    // is the time that the object took when it was made
};

class Compiler {
 public:
  // `cache` is a folder for shared objects, made if it is missing; the files that were used last stay,
  // kCacheBytes in all. Throws BadInput if there is no compiler or no cache.
  Compiler(const StagedKit& kit, std::filesystem::path cache, Isolation isolation);

  // May be called from any thread. `job` is one of the kit's folders, for this file only; the object is
  // written into it as <id>.so. `cpu_seconds` limits compiler and linker. Throws std::runtime_error if the
  // machine fails.
  Compiled compile(const Exercise& exercise, const std::string& source, const std::filesystem::path& job,
                   double cpu_seconds) const;

  const Toolchain& toolchain() const { return toolchain_; }

 private:
  std::string key(const Exercise& exercise, const std::string& source) const;
  Compiled run_compiler(const Exercise& exercise, const std::string& source, const std::filesystem::path& job,
                        double cpu_seconds) const;
  Compiled run_linker(const Exercise& exercise, const std::filesystem::path& job, double cpu_seconds) const;

  Toolchain toolchain_;
  PrecompiledHeader precompiled_;
  std::filesystem::path cache_;
  mutable std::mutex turns_mutex_;                   // guards the map
  mutable std::map<std::string, std::mutex> turns_;  // by the object's key: one thread at a time makes it
};

}  // namespace grader::compile
