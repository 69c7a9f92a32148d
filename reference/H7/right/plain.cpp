// STAFF ONLY. A right solution of H7 as Mirtich writes it: vectors of six numbers, matrices of 6 x 6, motions
// [alpha; a] and forces [f; tau].

#include "hair/rigid_links.h"

namespace hair {
namespace {

using Six = Eigen::Matrix<double, 6, 1>;
using Six6 = Eigen::Matrix<double, 6, 6>;
using Columns = Eigen::Matrix<double, 6, 3>;
using Rows = Eigen::Matrix<double, 3, 6>;

Six six(const SpatialMotion& m) {
  Six v;
  v << m.angular, m.linear;
  return v;
}

Six six(const SpatialForce& f) {
  Six v;
  v << f.force, f.torque;
  return v;
}

SpatialMotion motion(const Six& v) {
  return {v.head<3>(), v.tail<3>()};
}

SpatialForce force(const Six& v) {
  return {v.head<3>(), v.tail<3>()};
}

Six6 matrix(const SpatialInertia& inertia) {
  Six6 I;
  I << inertia.H.transpose(), inertia.M, inertia.J, inertia.H;
  return I;
}

SpatialInertia inertia(const Six6& I) {
  return {I.topRightCorner<3, 3>(), I.bottomRightCorner<3, 3>(), I.bottomLeftCorner<3, 3>()};
}

Matrix3d tilde(const Vector3d& r) {
  Matrix3d t;
  t << 0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0;
  return t;
}

// [1 0; -r~ 1]: from a parent to its child. With -r, back.
Six6 transform(const Vector3d& r) {
  Six6 X = Six6::Identity();
  X.bottomLeftCorner<3, 3>() = -tilde(r);
  return X;
}

// s', the spatial transpose, of each column.
Rows primed(const Columns& s) {
  Rows rows;
  rows << s.bottomRows<3>().transpose(), s.topRows<3>().transpose();
  return rows;
}

// Three axes; revolute and prismatic joints have 0 for the last two.
Columns axes(const Link& link) {
  Columns s = Columns::Zero();
  if (link.joint == JointType::spherical)
    s << Matrix3d::Identity(), -tilde(link.d);
  else if (link.joint == JointType::prismatic)
    s.col(0) << Vector3d::Zero(), link.u;
  else
    s.col(0) << link.u, link.u.cross(link.d);
  return s;
}

// The joint's own part of these numbers.
Vector3d own(const Link& link, Input values) {
  Vector3d three = Vector3d::Zero();
  for (int k = 0; k < rates_of(link.joint); ++k) three[k] = values[link.first + k];
  return three;
}

// The inverse in the joint's rows and columns, 0 elsewhere.
Matrix3d inverse(const Link& link, const Matrix3d& D) {
  if (link.joint == JointType::spherical) return D.inverse();
  Matrix3d gain = Matrix3d::Zero();
  gain(0, 0) = 1 / D(0, 0);
  return gain;
}

}  // namespace

void outward_velocities(const std::vector<Link>& links, Input rates, std::vector<LinkPass>& passes) {
  for (std::size_t i = 1; i < links.size(); ++i) {
    const Link& link = links[i];
    const Vector3d omega = passes[link.parent].v.angular;
    const Six joint = axes(link) * own(link, rates);
    passes[i].v = motion(transform(link.r) * six(passes[link.parent].v) + joint);
    const Vector3d w = joint.head<3>();
    passes[i].c = {};
    if (link.joint == JointType::prismatic) {
      const Vector3d slide = joint.tail<3>();
      passes[i].c.linear = omega.cross(omega.cross(link.r)) + 2 * omega.cross(slide);
    } else {
      if (link.joint == JointType::revolute) passes[i].c.angular = omega.cross(w);
      const Vector3d all = omega + w;
      passes[i].c.linear = omega.cross(omega.cross(link.r - link.d)) + passes[i].c.angular.cross(link.d) +
                           all.cross(all.cross(link.d));
    }
    const Vector3d spin = passes[i].v.angular;
    const Vector3d turning = spin.cross(link.tensor * spin);
    passes[i].bias.force = -link.external.force;
    passes[i].bias.torque = turning - link.external.torque;
  }
}

void inward_inertias(const std::vector<Link>& links, Input Q, std::vector<LinkPass>& passes) {
  std::vector<Six6> I;
  std::vector<Six> Z;
  for (std::size_t i = 0; i < links.size(); ++i) {
    I.push_back(matrix(links[i].inertia));
    Z.push_back(six(passes[i].bias));
  }
  for (std::size_t i = links.size() - 1; i > 0; --i) {
    const Link& link = links[i];
    const Columns s = axes(link), Is = I[i] * s;
    const Rows s_prime = primed(s);
    const Matrix3d gain = inverse(link, s_prime * Is + link.stiffening);
    const Six c = six(passes[i].c);
    const Six6 through = I[i] - Is * gain * s_prime * I[i];
    const Six carried = Z[i] + I[i] * c + Is * gain * (own(link, Q) - s_prime * (Z[i] + I[i] * c));
    I[link.parent] += transform(-link.r) * through * transform(link.r);
    Z[link.parent] += transform(-link.r) * carried;
    passes[i].gain = gain;
  }
  for (std::size_t i = 0; i < links.size(); ++i) {
    passes[i].inertia = inertia(I[i]);
    passes[i].bias = force(Z[i]);
  }
}

void outward_accelerations(const std::vector<Link>& links, Input Q, std::vector<LinkPass>& passes,
                           Output accelerations) {
  for (std::size_t i = 1; i < links.size(); ++i) {
    const Link& link = links[i];
    const Columns s = axes(link);
    const Six6 I = matrix(passes[i].inertia);
    const Six c = six(passes[i].c), from_parent = transform(link.r) * six(passes[link.parent].a);
    const Vector3d found = passes[i].gain * (own(link, Q) - primed(s) * (I * from_parent) -
                                             primed(s) * (six(passes[i].bias) + I * c));
    for (int k = 0; k < rates_of(link.joint); ++k) accelerations[link.first + k] = found[k];
    passes[i].a = motion(from_parent + s * found + c);
  }
}

}  // namespace hair
