// STAFF ONLY. The encodings of text that others wrote. Source code must be UTF-8, of which ASCII is a part:
// other files are told to their author in a sentence, with how to save them. Tables are decoded.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace grader::inline text {

// UTF-16 and UTF-32, with a byte order mark and without. Empty if it is neither.
std::string told_if_wide(std::string_view bytes, const std::string& file);

// The first byte that is no text in UTF-8, as of a name in Latin-1, or a NUL. Empty if there is none.
std::string told_of_stray_byte(std::string_view bytes, const std::string& file);

// Bytes of a code page ("CP1252", "SHIFT_JIS") as UTF-8, by the system's tables. Nothing if some have no
// letter there, or if the system has no such table.
std::optional<std::string> from_code_page(std::string_view bytes, const char* page);

// UTF-8 by default. `page` is the system's name of it.
struct Encoding {
  const char* page = "UTF-8";
  std::string_view mark = {};  // the byte order mark that stands in front
};

struct Decoded {
  std::string text;                 // well-formed UTF-8 without a byte order mark; a NUL may be in it
  std::vector<std::string> said{};  // a line each: what it was decoded from, if it was no plain UTF-8
  Encoding encoding{};
};

// UTF-8 and UTF-16, with a byte order mark and without. Windows-1252 is the guess for what is neither:
// spreadsheets in the west write it. UTF-32, half a UTF-16 unit and what is none of these throw BadInput with
// `file`.
Decoded decoded(std::string_view bytes, const std::string& file);

// UTF-8 in another encoding, with its mark. A letter that has no place there becomes one that resembles it,
// or a question mark.
std::string encoded(std::string_view text, const Encoding& encoding);

}  // namespace grader::text
