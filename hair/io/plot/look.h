// How series and classes are told apart: by colours that those who see fewer of them can tell apart, too, and
// never by colours alone.
#pragma once

#include <string>

namespace hair::plot {

inline constexpr const char* kText = "#1a1a1a";
inline constexpr const char* kFaint = "#e4e4e4";   // the grid
inline constexpr const char* kMiddle = "#767676";  // guides: 4.5 : 1 on white

// Seven of the eight colours of M. Okabe and K. Ito, "Color Universal Design" (2008); their yellow is left
// out, since a line of it can't be seen on white.
inline constexpr int kColours = 7, kMarkers = 12;
const char* colour(int series);

// A closed outline around (0, 0), as wide as a circle of that radius looks. Seven and twelve have no common
// divisor: colour and marker together come back after 84 series.
std::string marker_path(int series, double radius);

// stroke-dasharray of the dashed curves, one after the other.
const char* dashes(int dashed_curve);

}  // namespace hair::plot
