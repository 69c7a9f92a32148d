#include "hair/mass_spring/strand_start.h"

#include <cmath>
#include <string>

#include "hair/strand/make_strand.h"
#include "particles/require.h"

namespace hair {

using particles::require, particles::require_at_least, particles::require_direction,
    particles::require_finite, particles::require_positive;

StrandStart start_at_rest(const Material& material, const RestShape& shape) {
  StrandStart start{strand_from_rest(material, shape.x), {shape.x, Eigen::VectorXd::Zero(shape.x.size())}};
  start.strand.clamped = true;
  start.strand.root_tangent = shape.tangent;
  start.rest_curvature = bend_components(shape.x, shape.tangent, shape.normal);
  start.root_normal = shape.normal;
  return start;
}

StrandStart start_at_rest(const Fibre& fibre, const RestShape& shape, bool straight, bool clamped) {
  StrandStart start;
  if (straight || !clamped) {
    start = {strand_from_rest(fibre.material, shape.x), {shape.x, Eigen::VectorXd::Zero(shape.x.size())}};
    start.strand.clamped = clamped;
    start.strand.root_tangent = shape.tangent;
    start.root_normal = shape.normal;
  } else {
    start = start_at_rest(fibre.material, shape);
  }
  start.strand.stretch_rigidity *= fibre.stretch_factor;
  start.strand.bend_rigidity *= fibre.bend_factor;
  start.strand.skip_rigidity = fibre.skip_factor * start.strand.stretch_rigidity;
  return start;
}

void hold(const Held& held, StrandStart& start) {
  if (!held.differently) return;
  Eigen::VectorXd& x = start.state.x;
  for (int i = 0; i < start.strand.segments(); ++i) {
    const double along =
        (held.folded && i % 2 == 1 ? -held.stretch : held.stretch) * start.strand.rest_length[i];
    x.segment<3>(3 * i + 3) = x.segment<3>(3 * i) + along * held.direction;
    const Vector3d arm = x.segment<3>(3 * i + 3) - x.head<3>();
    start.state.v.segment<3>(3 * i + 3) = held.spin.cross(arm);
  }
}

StrandStart discretise(const StrandSpec& spec) {
  StrandStart start =
      start_at_rest(spec.fibre, rest_shape(spec), std::holds_alternative<Straight>(spec.form), spec.clamped);
  hold(spec.start, start);
  start.state.v.head<3>() = spec.root_velocity;
  return start;
}

void check_start(const std::string& name, const StrandStart& start) {
  const Strand& strand = start.strand;
  const int n = strand.count();
  require_at_least(name + ": the number of particles", n, 1);
  require(strand.segments() == n - 1, name + ": the number of segments", strand.segments(),
          std::to_string(n - 1));
  require(start.state.x.size() == 3 * n, name + ": the numbers in x", start.state.x.size(),
          std::to_string(3 * n));
  require(start.state.v.size() == 3 * n, name + ": the numbers in v", start.state.v.size(),
          std::to_string(3 * n));
  for (double mass : strand.mass) require_positive(name + ": a mass", mass);
  for (double length : strand.rest_length) require_positive(name + ": a rest length", length);
  require_at_least(name + ": EA", strand.stretch_rigidity, 0);
  require_at_least(name + ": EI", strand.bend_rigidity, 0);
  require_at_least(name + ": the rigidity of springs that skip a particle", strand.skip_rigidity, 0);
  if (strand.clamped) require_direction(name + ": the root's tangent", strand.root_tangent);
  require_finite(name + ": a position", start.state.x);
  require_finite(name + ": a velocity", start.state.v);
  require_finite(name + ": a component of the rest curvature", start.rest_curvature);
}

}  // namespace hair
