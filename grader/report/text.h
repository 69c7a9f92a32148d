// STAFF ONLY. Points as text.
#pragma once

#include <string>

namespace grader {

// Points as people write them: two decimals at most, no trailing zeros.
std::string shown_points(double points);

// The same with one decimal at most, for tables.
std::string short_points(double points);

// What is written where programs read on: without the noise of sums of fractions.
double rounded_points(double points);

}  // namespace grader
