// Colours of hair that have names.
#pragma once

#include <array>
#include <string_view>

namespace hair {

struct HairColour {
  std::string_view name;
  std::array<double, 3> root, tip;  // linear, 0 to 1
};

inline constexpr std::array<HairColour, 7> kHairColours = {{
    {"black", {0.010, 0.009, 0.008}, {0.022, 0.018, 0.015}},
    {"brown", {0.060, 0.030, 0.013}, {0.130, 0.070, 0.032}},
    {"chestnut", {0.100, 0.040, 0.015}, {0.210, 0.092, 0.035}},
    {"red", {0.210, 0.050, 0.012}, {0.360, 0.105, 0.028}},
    {"blond", {0.300, 0.185, 0.080}, {0.560, 0.390, 0.190}},
    {"grey", {0.220, 0.220, 0.215}, {0.380, 0.380, 0.375}},
    {"white", {0.560, 0.550, 0.520}, {0.740, 0.730, 0.700}},
}};

}  // namespace hair
