// STAFF ONLY. Points as text.
#pragma once

#include <string>

namespace grader::inline report {

// Points for readers: at most two decimals, no trailing zeros.
std::string shown_points(double points);

// The same with one decimal at most, for tables.
std::string short_points(double points);

// "20 of 200 points"; where all is extra credit: "15 points of extra credit".
std::string shown_total(double points, double max_points);

// Points for files that programs read: without the rounding noise of sums of fractions.
double rounded_points(double points);

}  // namespace grader::report
