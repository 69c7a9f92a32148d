#include "hair/strand/strand_spec.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace hair {

namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;

RestShape shape_of(const Straight&, const StrandSpec& spec) {
  return straight_shape(spec.elements, spec.length, spec.root);
}

RestShape shape_of(const Wavy& wave, const StrandSpec& spec) {
  return wavy_shape(spec.elements, spec.length, wave.amplitude, wave.wavelength, spec.root);
}

RestShape shape_of(const Curly& curl, const StrandSpec& spec) {
  return curly_shape(spec.elements, spec.length, curl.radius, curl.pitch, spec.root);
}

RestShape shape_of(const Drawn& drawn, const StrandSpec&) {
  RestShape shape{drawn.x, {}, {}};
  shape.tangent = (shape.x.segment<3>(3) - shape.x.head<3>()).normalized();
  shape.normal = side_of(shape.tangent);
  return shape;
}

Bend bend_of(const Straight&, double) {
  return {};
}

// y = A sin(kt): curvature y'' / (1 + y'^2)^(3/2), at the t where the curve's length is s.
Bend bend_of(const Wavy& wave, double s) {
  const double k = kFullTurn / wave.wavelength;
  const double t = wave_axis(wave.amplitude, wave.wavelength, s);
  const double slope = wave.amplitude * k * std::cos(k * t);
  const double bend = -wave.amplitude * k * k * std::sin(k * t);
  return {bend / std::pow(1 + slope * slope, 1.5), 0};
}

Bend bend_of(const Curly& curl, double) {
  const double c = curl.pitch / kFullTurn, squared = curl.radius * curl.radius + c * c;
  return {-curl.radius / squared, c / squared};
}

Bend bend_of(const Drawn&, double) {
  throw std::invalid_argument("a drawn strand has no curvature between its points");
}

// m: the length of the curl's turn; 0 if there is none.
double turn_of_curl(const RestForm& form) {
  const auto* curl = std::get_if<Curly>(&form);
  return curl ? std::hypot(kFullTurn * curl->radius, curl->pitch) : 0;
}

}  // namespace

bool is_wave_or_curl(const RestForm& form) {
  return std::holds_alternative<Wavy>(form) || std::holds_alternative<Curly>(form);
}

RestShape rest_shape(const StrandSpec& spec) {
  return std::visit([&](const auto& form) { return shape_of(form, spec); }, spec.form);
}

RestShape root_of_curve(const StrandSpec& spec) {
  StrandSpec piece = spec;
  if (const double turn = turn_of_curl(spec.form); turn > 0) {
    piece.length = std::min(spec.length, turn / 8);
    piece.elements = 1;
  }
  return rest_shape(piece);
}

StrandSpec finely_divided(const StrandSpec& spec) {
  StrandSpec divided = spec;
  if (const double turn = turn_of_curl(spec.form); turn > 0)
    divided.elements = std::max(spec.elements, static_cast<int>(std::ceil(5 * spec.length / turn)));
  return divided;
}

Bend bend_at(const RestForm& form, double s) {
  return std::visit([&](const auto& one) { return bend_of(one, s); }, form);
}

}  // namespace hair
