// STAFF ONLY. A right solution of H7 that refers all spatial vectors to one point, the base's origin: there a joint's axis is a
// line in space, nothing is transformed from link to link, and what the contract asks for is referred to a link's centre
// of mass at the end.

#include "hair/rigid_links.h"

namespace hair {
namespace {

std::vector<Vector3d> centers(const std::vector<Link>& links) {
  std::vector<Vector3d> at(links.size(), Vector3d::Zero());
  for (std::size_t i = 1; i < links.size(); ++i) at[i] = at[links[i].parent] + links[i].r;
  return at;
}

SpatialMotion at_point(const SpatialMotion& m, const Vector3d& from_center) {
  return {m.angular, m.linear + m.angular.cross(from_center)};
}

SpatialForce at_point(const SpatialForce& f, const Vector3d& from_center) {
  return {f.force, f.torque - from_center.cross(f.force)};
}

Matrix3d crossing(const Vector3d& r) {
  Matrix3d matrix;
  for (int k = 0; k < 3; ++k) matrix.col(k) = r.cross(Vector3d::Unit(k));
  return matrix;
}

// The joint's axes at the origin: lines through the joint, or directions.
struct Axes {
  SpatialMotion s[3];
  int count;
};

Axes axes(const Link& link, const Vector3d& center) {
  Axes axes{{}, rates_of(link.joint)};
  const Vector3d joint = center - link.d;
  for (int k = 0; k < axes.count; ++k) {
    const Vector3d u = link.joint == JointType::spherical ? Vector3d(Vector3d::Unit(k)) : link.u;
    axes.s[k] = link.joint == JointType::prismatic ? SpatialMotion{Vector3d::Zero(), u}
                                                   : SpatialMotion{u, joint.cross(u)};
  }
  return axes;
}

// The rate of change of a motion that moves with v: the cross product of spatial vectors.
SpatialMotion cross(const SpatialMotion& v, const SpatialMotion& m) {
  return {v.angular.cross(m.angular), v.angular.cross(m.linear) + v.linear.cross(m.angular)};
}

SpatialInertia moved(const SpatialInertia& inertia, const Vector3d& by) {
  const Matrix3d r = crossing(by);
  const Matrix3d H = inertia.H + r * inertia.M;
  return {inertia.M, H, inertia.J - H * r + r * inertia.H.transpose()};
}

}  // namespace

void outward_velocities(const std::vector<Link>& links, Input rates, std::vector<LinkPass>& passes) {
  const std::vector<Vector3d> at = centers(links);
  std::vector<SpatialMotion> v(links.size());
  v[0] = passes[0].v;
  for (std::size_t i = 1; i < links.size(); ++i) {
    const Link& link = links[i];
    const Axes joint = axes(link, at[i]);
    SpatialMotion turn;
    for (int k = 0; k < joint.count; ++k) turn += rates[link.first + k] * joint.s[k];
    const SpatialMotion& parent = v[link.parent];
    v[i] = parent + turn;
    passes[i].v = at_point(v[i], at[i]);

    // At the origin an acceleration is that of its spatial vector, and a point's has omega x v beside it. Axes that are
    // fixed in the parent change by its motion; those of spherical joints only move with their joint.
    SpatialMotion change = cross(parent, turn);
    if (link.joint == JointType::spherical) {
      const Vector3d joint_at = at[i] - link.d;
      change = {Vector3d::Zero(), at_point(parent, joint_at).linear.cross(turn.angular)};
    }
    SpatialMotion c = at_point(change, at[i]);
    c.linear += v[i].angular.cross(passes[i].v.linear);
    c.linear -= parent.angular.cross(passes[link.parent].v.linear);
    passes[i].c = c;

    const Vector3d spin = link.tensor * v[i].angular;
    passes[i].bias.force = -link.external.force;
    passes[i].bias.torque = v[i].angular.cross(spin) - link.external.torque;
  }
}

void inward_inertias(const std::vector<Link>& links, Input Q, std::vector<LinkPass>& passes) {
  const std::vector<Vector3d> at = centers(links);
  std::vector<SpatialInertia> I(links.size());
  std::vector<SpatialForce> Z(links.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    I[i] += moved(links[i].inertia, at[i]);
    Z[i] += at_point(passes[i].bias, -at[i]);
  }
  for (std::size_t i = links.size() - 1; i > 0; --i) {
    const Link& link = links[i];
    const Axes joint = axes(link, at[i]);
    const SpatialMotion c = at_point(passes[i].c, -at[i]);
    const SpatialForce needs = Z[i] + I[i] * c;
    Matrix3d D = Matrix3d::Identity();
    Vector3d left = Vector3d::Zero();
    SpatialForce Is[3];
    for (int k = 0; k < joint.count; ++k) {
      Is[k] = I[i] * joint.s[k];
      left[k] = Q[link.first + k] - dot(joint.s[k], needs);
    }
    for (int k = 0; k < joint.count; ++k)
      for (int l = 0; l < joint.count; ++l) D(k, l) = dot(joint.s[k], Is[l]) + link.stiffening(k, l);
    const Matrix3d gain = D.inverse();
    passes[i].gain.topLeftCorner(joint.count, joint.count) = gain.topLeftCorner(joint.count, joint.count);
    SpatialInertia through = I[i];
    SpatialForce carried = needs;
    for (int k = 0; k < joint.count; ++k)
      for (int l = 0; l < joint.count; ++l) {
        carried += gain(k, l) * left[l] * Is[k];
        through.M -= gain(k, l) * Is[k].force * Is[l].force.transpose();
        through.H -= gain(k, l) * Is[k].torque * Is[l].force.transpose();
        through.J -= gain(k, l) * Is[k].torque * Is[l].torque.transpose();
      }
    I[link.parent] += through;
    Z[link.parent] += carried;
  }
  for (std::size_t i = 0; i < links.size(); ++i) {
    passes[i].inertia = moved(I[i], -at[i]);
    passes[i].bias = at_point(Z[i], at[i]);
  }
}

void outward_accelerations(const std::vector<Link>& links, Input Q, std::vector<LinkPass>& passes,
                           Output accelerations) {
  const std::vector<Vector3d> at = centers(links);
  for (std::size_t i = 1; i < links.size(); ++i) {
    const Link& link = links[i];
    const Axes joint = axes(link, at[i]);
    // The parent's acceleration as if link i were a part of it.
    const SpatialMotion rigid = at_point(passes[link.parent].a, link.r) + passes[i].c;
    const SpatialForce needs = at_point(passes[i].inertia * rigid + passes[i].bias, -at[i]);
    Vector3d left = Vector3d::Zero();
    for (int k = 0; k < joint.count; ++k) left[k] = Q[link.first + k] - dot(joint.s[k], needs);
    SpatialMotion turn;
    for (int k = 0; k < joint.count; ++k) {
      double sum = 0;
      for (int l = 0; l < joint.count; ++l) sum += passes[i].gain(k, l) * left[l];
      accelerations[link.first + k] = sum;
      turn += sum * joint.s[k];
    }
    passes[i].a = rigid + at_point(turn, at[i]);
  }
}

}  // namespace hair
