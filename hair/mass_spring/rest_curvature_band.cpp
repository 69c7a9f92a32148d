#include "hair/mass_spring/rest_bend.h"
#include "hair/mass_spring/rest_curvature.h"
#include "solver/block_band.h"

namespace hair {

namespace {

using rest_bend::Joint;
using Rows = Eigen::Matrix<double, 2, 3>;

// A joint's derivatives by the positions of its three particles, with its frame held.
struct LocalJoint {
  Rows kappa[3];              // for its two components
  Eigen::RowVector3d phi[3];  // for its angle, if the joint is obtuse
};

// Converts derivatives by the segments' directions to derivatives by the particles' positions.
template <typename Derivative>
void by_particles(const Joint<double>& joint, const Derivative& by_u, const Derivative& by_v,
                  Derivative by_place[3]) {
  const Derivative below = (by_v - by_v * joint.v * joint.v.transpose()) / joint.length_below;
  by_place[2] = below;
  by_place[1] = -below;
  if (joint.above < 0) return;
  const Derivative above = (by_u - by_u * joint.u * joint.u.transpose()) / joint.length_above;
  by_place[1] += above;
  by_place[0] = -above;
}

LocalJoint local(const Joint<double>& joint) {
  LocalJoint result;
  Rows by_u, by_v;
  const Vector3d* axes[2] = {&joint.second, &joint.third};
  for (int c = 0; c < 2; ++c) {
    Vector3d axis = *axes[c];
    if (joint.is_obtuse()) {  // along b, uses the angle itself, without its cancelling quotient
      const double along = joint.b.dot(axis);
      axis -= joint.b * along;
      by_u.row(c) = joint.q * joint.v.cross(axis) - along * joint.b.cross(joint.u);
      by_v.row(c) = joint.q * axis.cross(joint.u) + along * joint.b.cross(joint.v);
    } else {
      const double along = joint.slope * joint.u_x_v.dot(axis);
      by_u.row(c) = joint.q * joint.v.cross(axis) - along * joint.v;
      by_v.row(c) = joint.q * axis.cross(joint.u) - along * joint.u;
    }
  }
  by_particles(joint, by_u, by_v, result.kappa);
  if (joint.is_obtuse())
    by_particles<Eigen::RowVector3d>(joint, -joint.b.cross(joint.u), joint.b.cross(joint.v), result.phi);
  return result;
}

}  // namespace

// For the part of the frame that it has lost, an obtuse joint keeps only the angle's term.
bool RestCurvature::add_band(Input x, Input, double by_dfdx, double, solver::BlockBand& band,
                             particles::Scratch) const {
  rest_bend::walk<double>(
      strand_, rest_, root_normal_, [&](int i) { return rest_bend::difference(x, i); },
      [&](const Joint<double>& joint) {
        if (joint.folded) return;
        const LocalJoint by = local(joint);
        const double of_kappa = by_dfdx * joint.stiffness * (joint.is_obtuse() ? joint.share : 1);
        const double of_phi = by_dfdx * joint.stiffness * (1 - joint.share);
        for (int i = joint.above < 0 ? 1 : 0; i < 3; ++i)
          for (int back = 0; back <= (joint.above < 0 ? i - 1 : i); ++back) {
            const int j = i - back;
            Eigen::Matrix3d block = -of_kappa * (by.kappa[i].transpose() * by.kappa[j]);
            if (joint.is_obtuse()) block -= of_phi * (by.phi[i].transpose() * by.phi[j]);
            band.block(joint.below - 1 + i, back) += block;
          }
      });
  return true;
}

}  // namespace hair
