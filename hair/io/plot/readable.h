// Makes untrusted text readable and safe for markup. Only this code decodes such bytes.
#pragma once

#include <string>
#include <string_view>

namespace hair {

// Well-formed UTF-8: every byte that isn't part of a valid sequence becomes U+FFFD.
std::string valid_utf8(std::string_view bytes);

// The same without terminal colours and without control characters other than newline and tab: safe for HTML,
// XML and readers. Removes whole escape sequences of terminals ("\x1b[31m"); other control characters become
// U+FFFD.
std::string readable(std::string_view bytes);

// The readable text with & < > " ' as entities, and marks that turn the direction of text by their number:
// safe in HTML and XML, including attributes.
std::string escaped(std::string_view bytes);

}  // namespace hair
