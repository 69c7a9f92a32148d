// Text from outside made fit for people to read, and for markup: the one place where its bytes are decoded.
#pragma once

#include <string>
#include <string_view>

namespace hair {

// Well-formed UTF-8: every byte that isn't part of a valid sequence becomes U+FFFD.
std::string valid_utf8(std::string_view bytes);

// The same without terminal colours and other control characters but newline and tab: fit for HTML, XML and
// reading. The escape sequences of terminals ("\x1b[31m") go as a whole, other control characters become
// U+FFFD.
std::string readable(std::string_view bytes);

// The readable text with & < > " ' as entities: fit for HTML and XML, attributes included.
std::string escaped(std::string_view bytes);

}  // namespace hair
