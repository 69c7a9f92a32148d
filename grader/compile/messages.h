// STAFF ONLY. What a student reads of what compiler and linker print.
#pragma once

#include <string>

namespace grader::inline compile {

// The compiler's messages about `file`'s own lines, a line each, and its errors elsewhere: it finds there
// what this file repeats or calls wrongly.
std::string own_messages(const std::string& log, const std::string& file);

// The warnings about `file`'s own lines, a line each: those of variables that nobody sets come first. Twenty
// at most.
std::string own_warnings(const std::string& log, const std::string& file);

// Names that the linker does not find, a line each, as C++ writes them. Ten at most.
std::string undefined_names(const std::string& log);

}  // namespace grader::compile
