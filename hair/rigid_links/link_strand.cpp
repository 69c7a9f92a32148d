#include "hair/rigid_links/link_strand.h"

#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "hair/strand/turns.h"

namespace hair {

using Eigen::Quaterniond;

namespace {

// The rods' axes at rest; those of the root come first.
std::vector<Quaterniond> axes_at_rest(const RestShape& shape, const Quaterniond& root) {
  std::vector<Quaterniond> axes = {root};
  Vector3d before = shape.tangent;
  for (Eigen::Index i = 0; i + 3 < shape.x.size(); i += 3) {
    const Vector3d along = (shape.x.segment<3>(i + 3) - shape.x.segment<3>(i)).normalized();
    axes.push_back(turn_between(before, along) * axes.back());
    axes.back().normalize();
    before = along;
  }
  return axes;
}

LinkShape rod(int number, double length, const Material& material) {
  LinkShape shape;
  shape.parent = number - 1;
  shape.joint = JointType::spherical;
  shape.center = Vector3d(0, 0, length / 2);
  shape.mass = material.line_density() * length;
  const double along = shape.mass * material.radius * material.radius / 2;
  const double across = along / 2 + shape.mass * length * length / 12;
  shape.moments = Vector3d(across, across, along);
  return shape;
}

// `mean`: the tangent of the joint, along the axes of its outer rod.
JointSpring spring(const Fibre& fibre, double length, const Vector3d& mean) {
  const double bend = fibre.bend_factor * fibre.material.bend_rigidity() / length;
  const double twist = fibre.twist_factor * fibre.material.twist_rigidity() / length;
  JointSpring spring;
  spring.stiffness = bend * Matrix3d::Identity() + (twist - bend) * mean * mean.transpose();
  spring.damping = fibre.relaxation_time * spring.stiffness;
  if (fibre.joint_limit) {
    spring.upper = *fibre.joint_limit;
    spring.limit_stiffness = kLimitFactor * fibre.material.bend_rigidity() / length;
  }
  return spring;
}

// Straight along `held.direction`, without twist, like the rods' axes at rest.
void hold(const Held& held, LinkStrand& strand) {
  const Vector3d tangent = strand.base.orientation * Vector3d::UnitZ();
  const Quaterniond straight = turn_between(tangent, held.direction) * strand.base.orientation;
  const Quaterniond back = straight * Quaterniond(0, 1, 0, 0);  // half a turn about x
  Quaterniond before = strand.base.orientation;
  for (int i = 1; i < strand.tree.links(); ++i) {
    const Quaterniond& axes = held.folded && i % 2 == 0 ? back : straight;
    const Quaterniond at_rest = before * strand.tree.shapes()[i].rest;
    strand.q.segment<4>(strand.tree.coordinate(i)) = (at_rest.conjugate() * axes).normalized().coeffs();
    before = axes;
  }
  strand.rates.head<3>() = held.spin;
}

}  // namespace

std::string why_not_of_links(const StrandSpec& spec) {
  if (spec.fibre.stretch_factor < 1)
    return "rigid links don't stretch; the stretch_factor must be at least 1";
  if (spec.fibre.skip_factor > 0)
    return "rigid links have no springs that skip a particle; the skip_factor must be 0";
  if (spec.start.differently && spec.start.stretch != 1)
    return "rigid links don't stretch; the start's stretch must be 1";
  if (is_wave_or_curl(spec.form) && !spec.clamped) return "wavy and curly hair must be clamped";
  try {
    rest_shape(spec);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

LinkStrand link_strand(const StrandSpec& spec) {
  if (const std::string why = why_not_of_links(spec); !why.empty()) throw std::invalid_argument(why);
  const RestShape shape = rest_shape(spec);
  TreeBase base;
  base.position = spec.root.position;
  base.orientation = root_axes(shape.tangent, shape.normal);
  const std::vector<Quaterniond> axes = axes_at_rest(shape, base.orientation);

  const int n = spec.elements;
  Eigen::VectorXd length(n);
  std::vector<LinkShape> rods;
  TreeForces forces;
  forces.bend_rigidity = spec.fibre.bend_factor * spec.fibre.material.bend_rigidity();
  forces.springs.resize(n + 1);
  forces.rods.assign(n + 1, Vector3d::Zero());
  for (int i = 1; i <= n; ++i) {
    const double l = (shape.x.segment<3>(3 * i) - shape.x.segment<3>(3 * i - 3)).norm();
    length[i - 1] = l;
    rods.push_back(rod(i, l, spec.fibre.material));
    rods.back().rest = (axes[i - 1].conjugate() * axes[i]).normalized();
    if (i > 1) rods.back().joint_at = Vector3d(0, 0, length[i - 2] / 2);
    forces.rods[i] = Vector3d(0, 0, l);
    if (i == 1 && !spec.clamped) continue;
    const Vector3d z = Vector3d::UnitZ(), inner = rods.back().rest.conjugate() * z;
    forces.springs[i] =
        spring(spec.fibre, i == 1 ? l / 2 : (length[i - 2] + l) / 2, (inner + z).normalized());
  }
  LinkStrand strand{LinkTree(rods), forces, length, base, spec.clamped, {}, {}};
  strand.q = strand.tree.rest();
  strand.rates = Eigen::VectorXd::Zero(strand.tree.rates());
  if (spec.start.differently) hold(spec.start, strand);
  return strand;
}

}  // namespace hair
