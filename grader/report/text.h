// STAFF ONLY. Text from outside made fit for what it is written into.
#pragma once

#include <string>
#include <string_view>

namespace grader {

// Well-formed UTF-8: every byte that isn't part of a valid sequence becomes U+FFFD.
std::string valid_utf8(std::string_view bytes);

// The same without terminal colours and other control characters but newline and tab: fit for HTML, XML and
// reading. The escape sequences of terminals ("\x1b[31m") go as a whole, other control characters become
// U+FFFD.
std::string readable(std::string_view bytes);

// The readable text with & < > " ' as entities: fit for HTML and XML, attributes included.
std::string escaped_markup(std::string_view bytes);

// Points as people write them: two decimals at most, no trailing zeros.
std::string shown_points(double points);

// The same with one decimal at most, for tables.
std::string short_points(double points);

// What is written where programs read on: without the noise of sums of fractions.
double rounded_points(double points);

}  // namespace grader
