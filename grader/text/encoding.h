// STAFF ONLY. The encodings of strangers' text. Source code must be UTF-8, which includes ASCII: for other
// files a sentence tells the author how to save them. Tables are decoded.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace grader::inline text {

// Describes UTF-16 and UTF-32, with a byte order mark and without. Empty for others.
std::string told_if_wide(std::string_view bytes, const std::string& file);

// Describes the first byte that is no text in UTF-8, as of a name in Latin-1, or a NUL; empty if none.
std::string told_of_stray_byte(std::string_view bytes, const std::string& file);

// Returns bytes of a code page ("CP1252", "SHIFT_JIS") as UTF-8, by the system's tables. Nothing if some have
// no letter there, or if the system has no such table.
std::optional<std::string> from_code_page(std::string_view bytes, const char* page);

// This is UTF-8 by default. `page` is the system's name of it.
struct Encoding {
  const char* page = "UTF-8";
  std::string_view mark = {};  // is the byte order mark in front
};

struct Decoded {
  std::string text;                 // is well-formed UTF-8 without a byte order mark; may contain NULs
  std::vector<std::string> said{};  // a line each: the old encoding, if it was no plain UTF-8
  Encoding encoding{};
};

// Decodes UTF-8 and UTF-16, with a byte order mark and without. Others are taken for Windows-1252, which
// western spreadsheets write. UTF-32, half a UTF-16 unit and bytes of none of these throw BadInput with
// `file`.
Decoded decoded(std::string_view bytes, const std::string& file);

// Writes UTF-8 in another encoding, with its mark. A letter that the encoding lacks becomes a similar one, or
// a question mark.
std::string encoded(std::string_view text, const Encoding& encoding);

}  // namespace grader::text
