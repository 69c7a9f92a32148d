#include "hair/strand/make_strand.h"

#include <cmath>
#include <numbers>
#include <string>

#include "particles/require.h"

namespace hair {

using particles::require, particles::require_at_least, particles::require_finite, particles::require_positive;

namespace {

Strand from_lengths(const Material& material, Eigen::VectorXd rest_length) {
  require_positive("a material's radius", material.radius);
  require_positive("a material's density", material.density);
  require_positive("Young's modulus", material.young_modulus);

  Strand strand;
  const Eigen::Index segments = rest_length.size();
  strand.mass.setZero(segments + 1);
  const Eigen::VectorXd half = material.line_density() / 2 * rest_length;
  strand.mass.head(segments) += half;
  strand.mass.tail(segments) += half;
  if (segments == 0)
    strand.mass[0] = material.density * 4 / 3 * std::numbers::pi * std::pow(material.radius, 3);
  for (double mass : strand.mass) require_positive("a particle's mass", mass);
  strand.rest_length = std::move(rest_length);
  strand.stretch_rigidity = material.stretch_rigidity();
  strand.bend_rigidity = material.bend_rigidity();
  require_finite("a strand's EA", strand.stretch_rigidity);
  require_finite("a strand's EI", strand.bend_rigidity);
  return strand;
}

}  // namespace

Strand uniform_strand(const Material& material, int segments, double length) {
  require_at_least("a strand's segments", segments, 1);
  require_positive("a strand's length", length);
  return from_lengths(material, Eigen::VectorXd::Constant(segments, length / segments));
}

Strand strand_from_rest(const Material& material, particles::Input x) {
  require_at_least("the numbers in a strand's positions", x.size(), 3);
  require(x.size() % 3 == 0, "the numbers in a strand's positions", static_cast<double>(x.size()),
          "a multiple of 3");
  for (double value : x) require_finite("a strand's position", value);
  const Eigen::Index n = x.size() / 3;
  Eigen::VectorXd rest_length(n - 1);
  for (Eigen::Index i = 0; i + 1 < n; ++i) {
    rest_length[i] = (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).norm();
    require_positive("the rest length of segment " + std::to_string(i), rest_length[i]);
  }
  return from_lengths(material, std::move(rest_length));
}

}  // namespace hair
