// STAFF ONLY. The part of compiler's and linker's output that a student reads.
#pragma once

#include <string>

namespace grader::inline compile {

// Returns the compiler's messages about `file`'s own lines, a line each, and its errors elsewhere: these come
// from definitions that this file repeats or functions that it calls wrongly.
std::string own_messages(const std::string& log, const std::string& file);

// Returns the warnings about `file`'s own lines, a line each: unset variables come first. Twenty at most.
std::string own_warnings(const std::string& log, const std::string& file);

// Returns names that the linker does not find, a line each, as C++ writes them. Ten at most.
std::string undefined_names(const std::string& log);

}  // namespace grader::compile
