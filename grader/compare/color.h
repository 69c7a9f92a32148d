// STAFF ONLY. Colours for FLIP. Here XYZ means CIE 1931 XYZ divided by the XYZ of D65's white, so that grey
// has three equal values and white is (1, 1, 1).
//
// Sources: IEC 61966-2-1 (sRGB); CIE 15 (L*a*b*); X. Zhang and B. A. Wandell, "A spatial extension of CIELAB
// for digital color-image reproduction", 1997 (Y_y C_x C_z, linear in XYZ).
#pragma once

#include <array>
#include <cstdint>

namespace grader::inline compare {

using Color = std::array<double, 3>;

double linear_from_srgb(std::uint8_t encoded);  // returns 0 to 1

Color xyz_from_linear(const Color& rgb);
Color linear_from_xyz(const Color& xyz);

// Y_y = 116 Y - 16, C_x = 500 (X - Y), C_z = 200 (Y - Z), and the inverse: L*a*b* without its cube root.
Color ycxcz_from_xyz(const Color& xyz);
Color xyz_from_ycxcz(const Color& ycxcz);

Color lab_from_xyz(const Color& xyz);

}  // namespace grader::compare
