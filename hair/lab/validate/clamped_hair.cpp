#include "hair/lab/validate/clamped_hair.h"

#include <cmath>

#include "hair/mass_spring/force_parts.h"
#include "hair/strand/make_strand.h"

namespace hair {

double weight_over_stiffness(const Material& material, double length) {
  return material.line_density() * kEarthGravity * std::pow(length, 3) / material.bend_rigidity();
}

double length_of(const Material& material, double weight_over_stiffness) {
  return std::cbrt(weight_over_stiffness * material.bend_rigidity() /
                   (material.line_density() * kEarthGravity));
}

StrandStart clamped_hair(const Material& material, int segments, double length, const Vector3d& direction) {
  StrandStart start;
  start.strand = uniform_strand(material, segments, length);
  start.strand.clamped = true;
  start.strand.root_tangent = direction;
  start.state.x =
      straight_shape(segments, length, {Vector3d::Zero(), direction, direction.unitOrthogonal()}).x;
  start.state.v.setZero(start.state.x.size());
  return start;
}

std::unique_ptr<MovingStrand> under_gravity(const StrandStart& start, const Vector3d& gravity) {
  const ForceOptions options{GeometricTerm::full, Products::exact, gravity};
  auto moving = std::make_unique<MovingStrand>(start.strand, start.state);
  add_forces(options, start, *moving);
  return moving;
}

}  // namespace hair
