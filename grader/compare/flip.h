// STAFF ONLY. LDR-FLIP: the visible difference of two pictures for a person who flips between them. Source:
// P. Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom and M. D. Fairchild, "FLIP: A
// Difference Evaluator for Alternating Images", Proceedings of the ACM on Computer Graphics and Interactive
// Techniques
// 3(2), 2020.
//
// FLIP combines two pipelines. Colour: details below the eye's resolution at this distance are filtered out,
// and the rest is compared in a uniform colour space. Features: edges and points that only one picture has.
// In each pixel FLIP = colour^(1 - feature).
#pragma once

#include <array>
#include <cstdint>

#include "grader/compare/plane.h"
#include "hair/io/image/image.h"

namespace grader::inline compare {

using ErrorMap = Plane;  // 0 (no difference) to 1

// Assumes a viewing distance of about 0.96 m from a screen with 0.25 mm pixels.
inline constexpr double kPixelsPerDegree = 67;

// Both pictures must have the same size, and pixels_per_degree must be 1 to 1000, else throws
// std::invalid_argument. FLIP is symmetric.
ErrorMap flip(const hair::Image& reference, const hair::Image& test,
              double pixels_per_degree = kPixelsPerDegree);

// Colours for FLIP. Here XYZ means CIE 1931 XYZ divided by the XYZ of D65's white, so that grey
// has three equal values and white is (1, 1, 1).
//
// Sources: IEC 61966-2-1 (sRGB); CIE 15 (L*a*b*); X. Zhang and B. A. Wandell, "A spatial extension of CIELAB
// for digital color-image reproduction", 1997 (Y_y C_x C_z, linear in XYZ).

using Color = std::array<double, 3>;

double linear_from_srgb(std::uint8_t encoded);  // returns 0 to 1

Color xyz_from_linear(const Color& rgb);
Color linear_from_xyz(const Color& xyz);

// Y_y = 116 Y - 16, C_x = 500 (X - Y), C_z = 200 (Y - Z), and the inverse: L*a*b* without its cube root.
Color ycxcz_from_xyz(const Color& xyz);
Color xyz_from_ycxcz(const Color& ycxcz);

Color lab_from_xyz(const Color& xyz);

// The resolution of the eye: the contrast sensitivity S(f) = sum of a exp(-b f^2), f in cycles
// per degree, as a filter in the plane. Source of the constants: the paper on FLIP.

enum class Opponent { achromatic, red_green, blue_yellow };

// Filters a channel of Y_y C_x C_z as the eye does. A uniform channel does not change.
Plane seen(const Plane& channel, Opponent opponent, double pixels_per_degree);

}  // namespace grader::compare
