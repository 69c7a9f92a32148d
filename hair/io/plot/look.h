// The look of series and classes: colours that suit colour-blind readers, always together with another
// difference. A drawing has the light theme's colours; in a dark page a style sheet replaces each by its
// counterpart.
#pragma once

#include <string>

namespace hair::plot {

inline constexpr const char* kPaper = "#ffffff";
inline constexpr const char* kText = "#1a1a1a";
inline constexpr const char* kFaint = "#e4e4e4";   // the grid
inline constexpr const char* kSoft = "#f3f3f3";    // areas
inline constexpr const char* kMiddle = "#767676";  // guides: 4.5 : 1 on white
inline constexpr const char* kQuiet = "#555555";   // their names

// In each theme at least 4.5 : 1 against the paper, for names are written in them, and at least 15 apart
// (CIEDE2000) for all kinds of sight.
inline constexpr int kColours = 8, kMarkers = 11;
const char* colour(int series);

// The same colour in a dark page: of a series, or of another colour above.
std::string in_the_dark(const std::string& light);
std::string dark_style();  // the style sheet, for <style>

// A closed outline around (0, 0) that looks as wide as a circle of this radius. Eight and eleven have no
// common divisor, so each pair of colour and marker repeats only after 88 series.
std::string marker_path(int series, double radius);

// stroke-dasharray of the dashed curves, in their order.
const char* dashes(int dashed_curve);

}  // namespace hair::plot
