// STAFF ONLY. Whether a source file's bytes are text as compilers read it: UTF-8, of which ASCII is a part. What is not is told to
// the file's author in a sentence, with how to save it.
#pragma once

#include <string>
#include <string_view>

namespace grader {

// UTF-16 and UTF-32, with a byte order mark and without. Empty if it is neither.
std::string told_if_wide(std::string_view bytes, const std::string& file);

// The first byte that is no text in UTF-8, as of a name in Latin-1, or a NUL. Empty if there is none.
std::string told_of_stray_byte(std::string_view bytes, const std::string& file);

}  // namespace grader
