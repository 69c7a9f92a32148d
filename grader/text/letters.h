// STAFF ONLY. Letters of names, of people and of files. One name has several spellings as bytes: "ö" is one
// code point or two, and learning systems write names in lower case without spaces into names of files.
#pragma once

#include <string>
#include <string_view>

namespace grader::inline text {

// The composed form (NFC) as one line for people: bytes that are no UTF-8 become U+FFFD, blanks become one
// space, and none is at an end. Letters stay.
std::string composed(std::string_view name);

// As Canvas writes a sortable name: lower case, only letters, digits and their marks.
std::string squeezed(std::string_view name);

// Composed, in lower case: e-mail addresses and GitHub's logins are one in any case.
std::string lowered(std::string_view name);

// Without letters that Unicode says are not to be seen: a zero-width space, a byte order mark, a soft hyphen.
std::string without_unseen(std::string_view text);

bool is_utf8(std::string_view bytes);

// No more than 30 marks stand in a row (Unicode's stream-safe text, UAX #15). Composing others would take
// time that grows with the square of their number: all functions here leave the marks of such a text as they
// are.
bool is_stream_safe(std::string_view text);

// The composed form (NFC), else unchanged: folders stay folders. Bytes that are no UTF-8 stay as they are.
std::string composed_path(std::string_view path);

// "Müller" as "Muller": letters that are one of ASCII with marks lose these. Others stay.
std::string without_marks(std::string_view name);

// One line that is safe to print and keeps its letters: control characters, bytes that are no UTF-8 and
// letters that change the direction of others become \xNN. Cuts after about `most` bytes.
std::string legible(std::string_view text, std::size_t most = 200);

// Columns of a terminal that a legible text takes: a Chinese letter has two, a mark none.
std::size_t terminal_columns(std::string_view text);
// Its beginning in so many columns at most, with whole letters.
std::string first_columns(std::string_view text, std::size_t most);

}  // namespace grader::text
