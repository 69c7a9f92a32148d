// STAFF ONLY. Letters of names. One name has several spellings as bytes: "ö" is one code point or two, and learning systems write
// names in lower case without spaces into names of files.
#pragma once

#include <string>
#include <string_view>

namespace grader {

// The composed form (NFC) as one line for people: bytes that are no UTF-8 become U+FFFD, blanks become one space, and none is at an
// end. Letters stay.
std::string composed(std::string_view name);

// As Canvas writes a sortable name: lower case, only letters, digits and their marks.
std::string squeezed(std::string_view name);

// Composed, in lower case: e-mail addresses and GitHub's logins are one in any case.
std::string lowered(std::string_view name);

}  // namespace grader
