// STAFF ONLY. Names that an object file defines, so far as they are the sanitizers': whoever defines one of these answers for the look
// for memory errors. The object is not trusted.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace grader {

// The first symbol that the object (ELF, 64 bit) defines, local or not, and whose name is one of the sanitizers' runtime:
// "__asan_report_load8". Nothing if there is none, or if the bytes are no such object: then the linker refuses them.
std::optional<std::string> defined_sanitizer_symbol(std::string_view object);

}  // namespace grader
