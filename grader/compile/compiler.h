// STAFF ONLY. From a student's file to a shared object that exports the exercise's functions and nothing
// else.
//
// The file is compiled in a cage that holds it, the given headers and the system's compiler; it is linked in
// another that holds the object and the prerequisites' shared objects. Objects are cached by the content of
// all that went into them.
#pragma once

#include <filesystem>
#include <string>

#include "grader/compile/kit.h"
#include "grader/compile/precompiled.h"
#include "grader/compile/toolchain.h"
#include "grader/course/course.h"

namespace grader {

struct Compiled {
  std::filesystem::path object;  // empty: it did not compile
  std::string messages;          // for the student: what the compiler says about their own lines
  std::string log;               // for staff: all that compiler and linker printed
};

class Compiler {
 public:
  // `cache`: a folder for shared objects, made if need be. Throws BadInput if there is no compiler or no
  // cache.
  Compiler(const StagedKit& kit, std::filesystem::path cache, bool isolated);

  // `job` is a folder of the kit's for this one file; the object is written into it as <id>.so. Throws
  // std::runtime_error if it is the machine that fails.
  Compiled compile(const Exercise& exercise, const std::string& source,
                   const std::filesystem::path& job) const;

 private:
  std::string key(const Exercise& exercise, const std::string& source) const;
  Compiled run_compiler(const Exercise& exercise, const std::string& source,
                        const std::filesystem::path& job) const;
  Compiled run_linker(const Exercise& exercise, const std::filesystem::path& job) const;

  Toolchain toolchain_;
  PrecompiledHeader precompiled_;
  std::filesystem::path cache_;
};

// The lines of a compiler's output that speak of `file`, a line each, none of another file's text.
std::string own_messages(const std::string& log, const std::string& file);

}  // namespace grader
