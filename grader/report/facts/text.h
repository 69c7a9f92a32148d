// STAFF ONLY. Writes points as text.
#pragma once

#include <string>

namespace grader::inline report {

// Writes points for readers: at most two decimals, no trailing zeros.
std::string shown_points(double points);

// Does the same with one decimal at most, for tables.
std::string short_points(double points);

// Writes "20 of 200 points"; if all is extra credit: "15 points of extra credit".
std::string shown_total(double points, double max_points);

// Rounds points for files that programs read: it removes the rounding noise of sums of fractions.
double rounded_points(double points);

}  // namespace grader::report
