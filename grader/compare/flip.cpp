// STAFF ONLY. Computes FLIP's error map of two pictures.
#include "grader/compare/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace grader::inline compare {

namespace {

using hair::Image;
using Channels = std::array<Plane, 3>;

// These are the paper's constants: exponents q, the knee of the redistribution of errors (p_c, p_t), the
// width of an edge to the eye, in degrees.
constexpr double q_color = 0.7, q_feature = 0.5, p_color = 0.4, p_target = 0.95, feature_width = 0.082;

void check_sizes(const Image& a, const Image& b) {
  const auto shown = [](const Image& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height);
  };
  if (a.width != b.width || a.height != b.height || a.pixels.size() != b.pixels.size())
    throw std::invalid_argument("FLIP: pictures of " + shown(a) + " and " + shown(b) +
                                " pixels; it needs two of the same size");
}

Channels ycxcz_of(const Image& image) {
  std::array<double, 256> linear{};
  for (int i = 0; i < 256; ++i)
    linear[static_cast<std::size_t>(i)] = linear_from_srgb(static_cast<std::uint8_t>(i));
  Channels channels{Plane(image.width, image.height), Plane(image.width, image.height),
                    Plane(image.width, image.height)};
  for (std::size_t i = 0; i < channels[0].values.size(); ++i) {
    const std::uint8_t* pixel = image.pixels.data() + 3 * i;
    const Color color =
        ycxcz_from_xyz(xyz_from_linear({linear[pixel[0]], linear[pixel[1]], linear[pixel[2]]}));
    for (std::size_t c = 0; c < 3; ++c) channels[c].values[i] = static_cast<float>(color[c]);
  }
  return channels;
}

// Returns L*a*b* in which dark colours have less chroma: the Hunt effect.
Color hunt_lab(const Color& xyz) {
  const Color lab = lab_from_xyz(xyz);
  return {lab[0], 0.01 * lab[0] * lab[1], 0.01 * lab[0] * lab[2]};
}

// S. Abasi, M. Amani Tehran and M. D. Fairchild, "Distance metrics for very large color differences", 2020.
double hyab(const Color& a, const Color& b) {
  return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

// The argument goes from 0 to the largest difference, green to blue: most of the result's range goes to
// differences below p_c of it.
double redistributed(double difference) {
  static const double largest =
      std::pow(hyab(hunt_lab(xyz_from_linear({0, 1, 0})), hunt_lab(xyz_from_linear({0, 0, 1}))), q_color);
  const double value = std::pow(difference, q_color), knee = p_color * largest;
  if (value < knee) return p_target / knee * value;
  return std::min(1.0, p_target + (value - knee) / (largest - knee) * (1 - p_target));
}

Plane color_differences(const Channels& reference, const Channels& test, double pixels_per_degree) {
  std::array<Channels, 2> both;
  for (std::size_t i = 0; i < 2; ++i) {
    const Channels& channels = i == 0 ? reference : test;
    both[i] = {seen(channels[0], Opponent::achromatic, pixels_per_degree),
               seen(channels[1], Opponent::red_green, pixels_per_degree),
               seen(channels[2], Opponent::blue_yellow, pixels_per_degree)};
  }
  // Filtering can leave the colours that a screen shows.
  const auto shown = [](const Channels& channels, std::size_t i) {
    Color rgb = linear_from_xyz(
        xyz_from_ycxcz({channels[0].values[i], channels[1].values[i], channels[2].values[i]}));
    for (double& value : rgb) value = std::clamp(value, 0.0, 1.0);
    return hunt_lab(xyz_from_linear(rgb));
  };
  Plane differences(reference[0].width, reference[0].height);
  for (std::size_t i = 0; i < differences.values.size(); ++i)
    differences.values[i] = static_cast<float>(redistributed(hyab(shown(both[0], i), shown(both[1], i))));
  return differences;
}

// This is the first or second derivative of a Gaussian, its positive weights scaled to the sum 1, its
// negative ones to -1.
enum class Feature { edge, point };

Kernel detector(Feature feature, double sigma, int radius) {
  std::vector<double> weights;
  double positive = 0, negative = 0;
  for (int i = -radius; i <= radius; ++i) {
    const double square = i * i / (sigma * sigma);
    const double weight = (feature == Feature::edge ? -i : square - 1) * std::exp(-0.5 * square);
    (weight > 0 ? positive : negative) += std::abs(weight);
    weights.push_back(weight);
  }
  Kernel kernel;
  for (const double weight : weights)
    kernel.push_back(static_cast<float>(weight / (weight > 0 ? positive : negative)));
  return kernel;
}

// Measures an edge or a point in each pixel: the norm of the filter's results in both directions.
Plane strength(Feature feature, const Plane& brightness, double pixels_per_degree) {
  const double sigma = 0.5 * feature_width * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  const Kernel across = detector(feature, sigma, radius), along = gaussian(sigma, radius);
  Plane result = filtered(brightness, across, along);
  const Plane other = filtered(brightness, along, across);
  for (std::size_t i = 0; i < result.values.size(); ++i)
    result.values[i] = std::sqrt(result.values[i] * result.values[i] + other.values[i] * other.values[i]);
  return result;
}

Plane feature_differences(const Plane& reference, const Plane& test, double pixels_per_degree) {
  Plane largest(reference.width, reference.height);
  for (const Feature feature : {Feature::edge, Feature::point}) {
    const Plane a = strength(feature, reference, pixels_per_degree);
    const Plane b = strength(feature, test, pixels_per_degree);
    for (std::size_t i = 0; i < largest.values.size(); ++i)
      largest.values[i] = std::max(largest.values[i], std::abs(a.values[i] - b.values[i]));
  }
  return largest;
}

// Scales Y_y to 0 to 1.
Plane brightness_of(Plane achromatic_channel) {
  for (float& value : achromatic_channel.values) value = (value + 16) / 116;
  return achromatic_channel;
}

}  // namespace

ErrorMap flip(const Image& reference, const Image& test, double pixels_per_degree) {
  check_sizes(reference, test);
  if (!(pixels_per_degree >= 1 && pixels_per_degree <= 1000))
    throw std::invalid_argument("FLIP: " + std::to_string(pixels_per_degree) +
                                " pixels per degree; it needs 1 to 1000");
  if (reference == test) return {reference.width, reference.height};  // most frames of a film are equal
  const Channels a = ycxcz_of(reference), b = ycxcz_of(test);
  ErrorMap map = color_differences(a, b, pixels_per_degree);
  const Plane features = feature_differences(brightness_of(a[0]), brightness_of(b[0]), pixels_per_degree);
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    const double feature = std::pow(features.values[i] / std::numbers::sqrt2, q_feature);
    map.values[i] = static_cast<float>(std::pow(map.values[i], 1 - std::min(1.0, feature)));
  }
  return map;
}

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

namespace {

using std::numbers::pi;

// This is a exp(-b f^2): in degrees a Gaussian, a sqrt(pi / b) exp(-pi^2 x^2 / b).
struct Term {
  double a, b;
};
constexpr Term achromatic{1, 0.0047}, red_green{1, 0.0053}, blue_yellow{34.1, 0.04},
    blue_yellow_2{13.5, 0.025};

double sigma_of(const Term& term) {  // in degrees
  return std::sqrt(term.b / 2) / pi;
}

Plane seen(const Plane& channel, const Term& term, double pixels_per_degree) {
  // All terms get three standard deviations of the widest one.
  const int radius = static_cast<int>(std::ceil(3 * sigma_of(blue_yellow) * pixels_per_degree));
  const Kernel kernel = gaussian(sigma_of(term) * pixels_per_degree, radius);
  return filtered(channel, kernel, kernel);
}

// A sum of two Gaussians is no product of a row and a column, but each of them is. The paper takes the factor
// sqrt(pi / b) of one dimension in two: there the integral of a term is a sqrt(b / pi), not a.
Plane seen_blue_yellow(const Plane& channel, double pixels_per_degree) {
  const auto integral = [](const Term& term) { return term.a * std::sqrt(term.b / pi); };
  const double share = integral(blue_yellow) / (integral(blue_yellow) + integral(blue_yellow_2));
  Plane sum = seen(channel, blue_yellow, pixels_per_degree);
  const Plane second = seen(channel, blue_yellow_2, pixels_per_degree);
  for (std::size_t i = 0; i < sum.values.size(); ++i)
    sum.values[i] = static_cast<float>(share * sum.values[i] + (1 - share) * second.values[i]);
  return sum;
}

}  // namespace

Plane seen(const Plane& channel, Opponent opponent, double pixels_per_degree) {
  switch (opponent) {
    case Opponent::achromatic:
      return seen(channel, achromatic, pixels_per_degree);
    case Opponent::red_green:
      return seen(channel, red_green, pixels_per_degree);
    case Opponent::blue_yellow:
      return seen_blue_yellow(channel, pixels_per_degree);
  }
  return channel;
}

}  // namespace grader::compare
