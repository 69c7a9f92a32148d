// STAFF ONLY. Letters in names of files. Archives, disks and systems write one letter in several ways.
#pragma once

#include <string>
#include <string_view>

namespace grader {

bool is_utf8(std::string_view bytes);

// The composed form (NFC), else unchanged: folders stay folders. Bytes that are no UTF-8 stay as they are.
std::string composed_path(std::string_view path);

// "Müller" as "Muller": letters that are one of ASCII with marks lose these. Others stay.
std::string without_marks(std::string_view name);

// One line that is safe to print and keeps its letters: control characters, bytes that are no UTF-8 and letters that change the
// direction of others become \xNN. Cuts after about `most` bytes.
std::string legible(std::string_view text, std::size_t most = 200);

}  // namespace grader
