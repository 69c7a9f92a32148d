// STAFF ONLY. Finds definitions in an object file that would replace the sanitizers' functions. The object is
// not trusted.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace grader::inline compile {

// Returns the first symbol that the object (ELF, 64 bit) defines, local or not, with a name of the
// sanitizers' runtime: "__asan_report_load8, a name of ...". Or a second table of symbols: compilers make
// one, and the linker chooses. Nothing if there is neither, or if the bytes are no such object: then the
// linker refuses them. Takes time in proportion to the object's size.
std::optional<std::string> forbidden_definition(std::string_view object);

}  // namespace grader::compile
