// STAFF ONLY. A right solution of H7 that has no formula to move an inertia. Pass 1 differentiates velocities
// by Plücker's cross product of motions. Pass 2 writes the equations of a link and its joint in one symmetric
// table, for the motion of the parent and the joint's rates, and eliminates the rates. All numbers are long
// double.

#include <array>

#include "hair/rigid_links.h"

namespace hair {
namespace {

using Real = long double;

// Rows 0 to 5 are for the link's six motions (linear, then angular), the next ones for its joint's rates. The
// last column has the forces without acceleration.
struct Table {
  std::array<std::array<Real, 10>, 9> row{};
  int rates = 0;
};

int entry(int half, int axis) {
  return 3 * half + axis;
}

// The motion of the link, as six numbers, for one unit of a parent's motion or of a joint's rate.
std::array<Real, 6> six(const Vector3d& angular, const Vector3d& linear) {
  return {linear[0], linear[1], linear[2], angular[0], angular[1], angular[2]};
}

std::array<Real, 6> by_parent(const Link& link, int k) {
  const Vector3d unit = Vector3d::Unit(k % 3);
  return k < 3 ? six(Vector3d::Zero(), unit) : six(unit, unit.cross(link.r));
}

std::array<Real, 6> by_joint(const Link& link, int k) {
  if (link.joint == JointType::prismatic) return six(Vector3d::Zero(), link.u);
  const Vector3d axis = link.joint == JointType::revolute ? link.u : Vector3d(Vector3d::Unit(k));
  return six(axis, axis.cross(link.d));
}

using Six6 = std::array<std::array<Real, 6>, 6>;

Six6 numbers_of(const SpatialInertia& I) {
  Six6 A{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      A[entry(0, i)][entry(0, j)] = I.M(i, j);
      A[entry(1, i)][entry(0, j)] = I.H(i, j);
      A[entry(0, i)][entry(1, j)] = I.H(j, i);
      A[entry(1, i)][entry(1, j)] = I.J(i, j);
    }
  return A;
}

Real product(const std::array<Real, 6>& a, const Six6& A, const std::array<Real, 6>& b) {
  Real sum = 0;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) sum += a[i] * A[i][j] * b[j];
  return sum;
}

// The forces on the parent and the joint.
Table table_of(const Link& link, const LinkPass& pass, Input Q) {
  Table table;
  table.rates = rates_of(link.joint);
  const Six6 I = numbers_of(pass.inertia);
  const std::array<Real, 6> c = six(pass.c.angular, pass.c.linear),
                            Z = six(pass.bias.torque, pass.bias.force);
  std::array<std::array<Real, 6>, 9> motion;
  for (int k = 0; k < 6 + table.rates; ++k) motion[k] = k < 6 ? by_parent(link, k) : by_joint(link, k - 6);
  for (int k = 0; k < 6 + table.rates; ++k) {
    for (int m = 0; m < 6 + table.rates; ++m) table.row[k][m] = product(motion[k], I, motion[m]);
    Real bias = product(motion[k], I, c);
    for (int i = 0; i < 6; ++i) bias += motion[k][i] * Z[i];
    table.row[k][9] = bias;
  }
  for (int k = 0; k < table.rates; ++k) {
    for (int m = 0; m < table.rates; ++m) table.row[6 + k][6 + m] += link.stiffening(k, m);
    table.row[6 + k][9] -= Q[link.first + k];
  }
  return table;
}

Matrix3d inverse_of_joint(const Table& table) {
  Matrix3d gain = Matrix3d::Zero();
  if (table.rates == 1) {
    gain(0, 0) = static_cast<double>(1 / table.row[6][6]);
    return gain;
  }
  Eigen::Matrix<Real, 3, 3> A;
  for (int k = 0; k < 3; ++k)
    for (int m = 0; m < 3; ++m) A(k, m) = table.row[6 + k][6 + m];
  return A.inverse().cast<double>();
}

void eliminate_rates(Table& table) {
  for (int p = 5 + table.rates; p >= 6; --p)
    for (int k = 0; k < p; ++k) {
      const Real part = table.row[k][p] / table.row[p][p];
      for (int m = 0; m < p; ++m) table.row[k][m] -= part * table.row[p][m];
      table.row[k][9] -= part * table.row[p][9];
    }
}

}  // namespace

void outward_velocities(const std::vector<Link>& links, Input rates, std::vector<LinkPass>& passes) {
  for (std::size_t i = 1; i < links.size(); ++i) {
    const Link& link = links[i];
    const SpatialMotion& parent = passes[link.parent].v;
    SpatialMotion own;  // the joint's motion
    for (int k = 0; k < rates_of(link.joint); ++k) {
      const std::array<Real, 6> s = by_joint(link, k);
      for (int j = 0; j < 3; ++j) {
        own.linear[j] += static_cast<double>(s[j] * rates[link.first + k]);
        own.angular[j] += static_cast<double>(s[3 + j] * rates[link.first + k]);
      }
    }
    // The parent's velocity at the link's centre.
    const SpatialMotion carried = to_child(parent, link.r);
    LinkPass& pass = passes[i];
    pass.v = carried + own;
    // A joint's axis moves with the parent; accelerations of points have omega x v in addition to those of
    // motions.
    pass.c.angular = parent.angular.cross(own.angular);
    pass.c.linear = parent.angular.cross(own.linear) + carried.linear.cross(own.angular) +
                    pass.v.angular.cross(pass.v.linear) - parent.angular.cross(parent.linear);
    if (link.joint == JointType::spherical) {
      pass.c.linear -= pass.c.angular.cross(link.d);
      pass.c.angular.setZero();
    }
    const Vector3d momentum = link.tensor * pass.v.angular;
    pass.bias = {-link.external.force, pass.v.angular.cross(momentum) - link.external.torque};
  }
}

void inward_inertias(const std::vector<Link>& links, Input Q, std::vector<LinkPass>& passes) {
  for (std::size_t i = 0; i < links.size(); ++i) passes[i].inertia = links[i].inertia;
  for (std::size_t i = links.size() - 1; i > 0; --i) {
    Table table = table_of(links[i], passes[i], Q);
    passes[i].gain = inverse_of_joint(table);
    eliminate_rates(table);
    LinkPass& parent = passes[links[i].parent];
    for (int k = 0; k < 3; ++k) {
      parent.bias.force[k] += static_cast<double>(table.row[entry(0, k)][9]);
      parent.bias.torque[k] += static_cast<double>(table.row[entry(1, k)][9]);
      for (int m = 0; m < 3; ++m) {
        parent.inertia.M(k, m) += static_cast<double>(table.row[entry(0, k)][entry(0, m)]);
        parent.inertia.H(k, m) += static_cast<double>(table.row[entry(1, k)][entry(0, m)]);
        parent.inertia.J(k, m) += static_cast<double>(table.row[entry(1, k)][entry(1, m)]);
      }
    }
  }
}

void outward_accelerations(const std::vector<Link>& links, Input Q, std::vector<LinkPass>& passes,
                           Output accelerations) {
  for (std::size_t i = 1; i < links.size(); ++i) {
    const Link& link = links[i];
    LinkPass& pass = passes[i];
    const Table table = table_of(link, pass, Q);
    const SpatialMotion& parent = passes[link.parent].a;
    const std::array<Real, 6> a = six(parent.angular, parent.linear);
    std::array<Real, 3> left{};
    for (int k = 0; k < table.rates; ++k) {
      left[k] = -table.row[6 + k][9];
      for (int m = 0; m < 6; ++m) left[k] -= table.row[6 + k][m] * a[m];
    }
    pass.a = to_child(parent, link.r) + pass.c;
    for (int k = 0; k < table.rates; ++k) {
      Real found = 0;
      for (int m = 0; m < table.rates; ++m) found += pass.gain(k, m) * left[m];
      accelerations[link.first + k] = static_cast<double>(found);
      const std::array<Real, 6> s = by_joint(link, k);
      for (int j = 0; j < 3; ++j) {
        pass.a.linear[j] += static_cast<double>(found * s[j]);
        pass.a.angular[j] += static_cast<double>(found * s[3 + j]);
      }
    }
  }
}

}  // namespace hair
