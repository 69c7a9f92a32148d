// STAFF ONLY. Converts colours between sRGB, XYZ, CIELAB and FLIP's opponent space.
#include "grader/compare/color.h"

#include <cmath>

namespace grader::inline compare {
namespace {

using Matrix = std::array<Color, 3>;

constexpr Color product(const Matrix& m, const Color& v) {
  Color result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return result;
}

// Returns sRGB's primaries and white, from their exact chromaticities: (0.64, 0.33), (0.30, 0.60), (0.15,
// 0.06) and (0.3127, 0.3290). Each row is then divided by its sum, white's X, Y or Z.
constexpr Matrix relative_to_white(Matrix m) {
  for (Color& row : m) {
    const double white = row[0] + row[1] + row[2];
    for (double& entry : row) entry /= white;
  }
  return m;
}

constexpr Matrix to_xyz =
    relative_to_white({{{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                        {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                        {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}});

// Uses cofactors: row j, column i of the inverse is the cofactor of row i, column j over the determinant.
constexpr Matrix inverse(const Matrix& m) {
  Matrix cofactors{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t k = (i + 1) % 3, l = (i + 2) % 3, p = (j + 1) % 3, q = (j + 2) % 3;
      cofactors[i][j] = m[k][p] * m[l][q] - m[k][q] * m[l][p];
    }
  const double determinant =
      m[0][0] * cofactors[0][0] + m[0][1] * cofactors[0][1] + m[0][2] * cofactors[0][2];
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[j][i] = cofactors[i][j] / determinant;
  return result;
}

constexpr Matrix from_xyz = inverse(to_xyz);

double lab_curve(double t) {
  constexpr double delta = 6.0 / 29;
  return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

}  // namespace

double linear_from_srgb(std::uint8_t encoded) {
  const double value = encoded / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

Color xyz_from_linear(const Color& rgb) {
  return product(to_xyz, rgb);
}

Color linear_from_xyz(const Color& xyz) {
  return product(from_xyz, xyz);
}

Color ycxcz_from_xyz(const Color& xyz) {
  return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

Color xyz_from_ycxcz(const Color& ycxcz) {
  const double y = (ycxcz[0] + 16) / 116;
  return {y + ycxcz[1] / 500, y, y - ycxcz[2] / 200};
}

Color lab_from_xyz(const Color& xyz) {
  const double x = lab_curve(xyz[0]), y = lab_curve(xyz[1]), z = lab_curve(xyz[2]);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

}  // namespace grader::compare
