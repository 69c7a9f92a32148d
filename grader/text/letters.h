// STAFF ONLY. The letters of names, of people and of files. One name has several spellings as bytes: "ö" is
// one code point or two, and learning systems write names in lower case without spaces into names of files.
#pragma once

#include <string>
#include <string_view>

namespace grader::inline text {

// Returns the composed form (NFC) as one line for people: bytes that are no UTF-8 become U+FFFD, blanks
// become one space, and none is at an end. Letters stay.
std::string composed(std::string_view name);

// Writes a sortable name as Canvas does: lower case, only letters, digits and their marks.
std::string squeezed(std::string_view name);

// Composes, in lower case: e-mail addresses and GitHub's logins are equal in any case.
std::string lowered(std::string_view name);

// Removes letters that Unicode calls invisible: a zero-width space, a byte order mark, a soft hyphen.
std::string without_unseen(std::string_view text);

bool is_utf8(std::string_view bytes);

// True if no more than 30 marks stand in a row (Unicode's stream-safe text, UAX #15). Composing other texts
// would take quadratic time: all functions here leave the marks of such a text unchanged.
bool is_stream_safe(std::string_view text);

// Returns the composed form (NFC), else the same path: folders stay folders, and invalid UTF-8 stays.
std::string composed_path(std::string_view path);

// Writes "Müller" as "Muller": letters of ASCII with marks lose these. Others stay.
std::string without_marks(std::string_view name);

// True if the text has this word of ASCII, apart from other letters, digits and underscores.
bool has_word(std::string_view text, std::string_view word);

// Returns one line that is safe to print and keeps its letters: control characters, bytes that are no UTF-8
// and letters that change the direction of others become \xNN. Cuts after about `most` bytes.
std::string legible(std::string_view text, std::size_t most = 200);

// Counts the columns of a terminal that a legible text takes: a Chinese letter has two, a mark none.
std::size_t terminal_columns(std::string_view text);
// Returns its beginning in at most `most` columns, with whole letters.
std::string first_columns(std::string_view text, std::size_t most);

}  // namespace grader::text
