#include "hair/super_helix/helix_start.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "hair/strand/turns.h"

namespace hair {

namespace {

constexpr int kMeans = 16;  // points of a mean along an element

Vector3d natural_of(const Bend& bend) {
  return {0, bend.curvature, bend.torsion};  // n1 is the normal: dt/ds = kappa2 n1
}

Eigen::VectorXd natural_of(const StrandSpec& spec) {
  const double length = spec.length / spec.elements;
  Eigen::VectorXd natural = Eigen::VectorXd::Zero(3 * spec.elements);
  for (int i = 0; i < spec.elements; ++i)
    for (int k = 0; k < kMeans; ++k)
      natural.segment<3>(3 * i) += natural_of(bend_at(spec.form, (i + (k + 0.5) / kMeans) * length)) / kMeans;
  return natural;
}

// Along axes that go from piece to piece without turning about them.
Eigen::VectorXd natural_of(const Drawn& drawn, const Eigen::Quaterniond& root,
                           const Eigen::VectorXd& lengths) {
  Eigen::VectorXd natural = Eigen::VectorXd::Zero(3 * lengths.size());
  const auto piece = [&](Eigen::Index i) -> Vector3d {
    return (drawn.x.segment<3>(3 * i + 3) - drawn.x.segment<3>(3 * i)).normalized();
  };
  Eigen::Quaterniond axes = root;
  for (Eigen::Index i = 1; i < lengths.size(); ++i) {
    const auto turn = turn_between(piece(i - 1), piece(i));
    const Vector3d bend = axes.conjugate() * turn_of(turn);
    natural.segment<3>(3 * i - 3) += bend / (2 * lengths[i - 1]);
    natural.segment<3>(3 * i) += bend / (2 * lengths[i]);
    axes = (turn * axes).normalized();
  }
  return natural;
}

Eigen::VectorXd lengths_of(const StrandSpec& spec) {
  const auto* drawn = std::get_if<Drawn>(&spec.form);
  if (!drawn) return Eigen::VectorXd::Constant(spec.elements, spec.length / spec.elements);
  Eigen::VectorXd lengths(spec.elements);
  for (int i = 0; i < spec.elements; ++i)
    lengths[i] = (drawn->x.segment<3>(3 * i + 3) - drawn->x.segment<3>(3 * i)).norm();
  return lengths;
}

// rad: the turn of an element of the rest shape.
double turn_of_element(const StrandSpec& spec) {
  const auto* curl = std::get_if<Curly>(&spec.form);
  if (!curl) return 0;
  const Bend bend = bend_at(spec.form, 0);
  return spec.length / spec.elements * std::hypot(bend.curvature, bend.torsion);
}

int drawn_points(const StrandSpec& spec) {
  const int smooth = static_cast<int>(std::ceil(turn_of_element(spec) / kDrawnTurn));
  return std::max({1, smooth, (kDrawnPoints + spec.elements - 1) / spec.elements});
}

std::string why_not_held(const StrandSpec& spec) {
  if (!spec.start.differently) return {};
  if (spec.start.stretch != 1) return "super-helices don't stretch; the start's stretch must be 1";
  if (spec.start.folded) return "super-helices have no folds; the start must not be folded";
  if (spec.start.spin != Vector3d::Zero()) return "super-helices are clamped; the start's spin must be 0";
  if (!(spec.start.direction.dot(root_of_curve(spec).tangent) > 1 - 1e-9))
    return "super-helices leave their roots along the roots' direction; give the start this direction, or "
           "leave it out";
  return {};
}

}  // namespace

std::string why_not_of_helices(const StrandSpec& spec) {
  const Fibre& fibre = spec.fibre;
  if (fibre.stretch_factor < 1) return "super-helices don't stretch; the stretch_factor must be at least 1";
  if (fibre.skip_factor > 0)
    return "super-helices have no springs that skip a particle; the skip_factor must be 0";
  if (fibre.joint_limit) return "super-helices have no joints; leave the joint_limit out";
  if (!(fibre.bend_factor > 0 && fibre.twist_factor > 0))
    return "super-helices resist bends and twists; the bend_factor and the twist_factor must be above 0";
  if (!spec.clamped) return "super-helices must be clamped";
  if (spec.elements > kMostHelices)
    return "super-helices have at most " + std::to_string(kMostHelices) +
           " elements; each bends and twists, so that few are enough";
  try {
    if (!std::holds_alternative<Curly>(spec.form)) rest_shape(spec);
    root_of_curve(spec);
    if (turn_of_element(spec) > 2 * std::numbers::pi * kMostTurns)
      return "elements of super-helices wind up to " + std::to_string(static_cast<int>(kMostTurns)) +
             " times; give the strand more of them";
    return why_not_held(spec);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

long helix_points(const StrandSpec& spec) {
  const auto nodes = static_cast<long>(8 * std::ceil(1 + turn_of_element(spec) / 2));
  return spec.elements * (drawn_points(spec) + nodes);
}

HelixStart helix_start(const StrandSpec& spec) {
  if (const std::string why = why_not_of_helices(spec); !why.empty()) throw std::invalid_argument(why);
  const RestShape shape = root_of_curve(spec);
  const Material& material = spec.fibre.material;
  const Eigen::Quaterniond root = root_axes(shape.tangent, shape.normal);
  HelixStart start;
  HelixStrand& strand = start.strand;
  strand.lengths = lengths_of(spec);
  strand.line_density = material.line_density();
  strand.bend_rigidity = spec.fibre.bend_factor * material.bend_rigidity();
  strand.twist_rigidity = spec.fibre.twist_factor * material.twist_rigidity();
  const auto* drawn = std::get_if<Drawn>(&spec.form);
  strand.natural = drawn ? natural_of(*drawn, root, strand.lengths) : natural_of(spec);
  start.root.frame = {spec.root.position, root.toRotationMatrix()};
  start.q = spec.start.differently ? Eigen::VectorXd::Zero(strand.natural.size()) : strand.natural;

  const int count = drawn_points(spec);
  start.places = {0};
  double at = 0;
  for (const double length : strand.lengths) {
    for (int k = 1; k <= count; ++k) start.places.push_back(at + k * length / count);
    at += length;
  }
  return start;
}

}  // namespace hair
