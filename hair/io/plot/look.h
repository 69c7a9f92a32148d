// The look of series and classes: colours that suit colour-blind readers, always together with another
// difference.
#pragma once

#include <string>

namespace hair::plot {

inline constexpr const char* kText = "#1a1a1a";
inline constexpr const char* kFaint = "#e4e4e4";   // the grid
inline constexpr const char* kMiddle = "#767676";  // guides: 4.5 : 1 on white

// Seven of the eight colours of M. Okabe and K. Ito, "Color Universal Design" (2008). Their yellow is left
// out, because a yellow line on white is invisible.
inline constexpr int kColours = 7, kMarkers = 12;
const char* colour(int series);

// A closed outline around (0, 0) that looks as wide as a circle of this radius. Seven and twelve have no
// common divisor, so each pair of colour and marker repeats only after 84 series.
std::string marker_path(int series, double radius);

// stroke-dasharray of the dashed curves, in their order.
const char* dashes(int dashed_curve);

}  // namespace hair::plot
