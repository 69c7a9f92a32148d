// STAFF ONLY. A right solution of H7 that differentiates velocities by time, with vectors that carry their
// change, so that it needs no formula of c^. It uses long double, symmetric matrices ([linear; angular] and
// [force; torque]), and Cholesky's factor of s'I s.

#include <Eigen/Cholesky>

#include "hair/rigid_links.h"

namespace hair {
namespace {

using Real = long double;
using Long3 = Eigen::Matrix<Real, 3, 1>;
using Long33 = Eigen::Matrix<Real, 3, 3>;
using Six = Eigen::Matrix<Real, 6, 1>;
using Six6 = Eigen::Matrix<Real, 6, 6>;
using Axes = Eigen::Matrix<Real, 6, Eigen::Dynamic, 0, 6, 3>;
using Rates = Eigen::Matrix<Real, Eigen::Dynamic, 1, 0, 3, 1>;
using Small = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;

Long3 wide(const Vector3d& v) {
  return v.cast<Real>();
}

// A vector, and its change per second.
struct Moving {
  Long3 now, change;
};
Moving operator+(const Moving& a, const Moving& b) {
  return {a.now + b.now, a.change + b.change};
}
Moving cross(const Moving& a, const Moving& b) {
  return {a.now.cross(b.now), a.change.cross(b.now) + a.now.cross(b.change)};
}
Moving turning(const Long3& v, const Long3& omega) {
  return {v, omega.cross(v)};
}
Moving steady(const Long3& v) {
  return {v, Long3::Zero()};
}

Six six(const Long3& linear, const Long3& angular) {
  Six v;
  v << linear, angular;
  return v;
}

Long33 cross_matrix(const Long3& r) {
  Long33 m;
  m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return m;
}

// A child's motion as a part of its parent.
Six6 carried(const Vector3d& r) {
  Six6 X = Six6::Identity();
  X.topRightCorner<3, 3>() = -cross_matrix(wide(r));
  return X;
}

Axes axes_of(const Link& link) {
  Axes s(6, rates_of(link.joint));
  const Long3 u = wide(link.u), d = wide(link.d);
  switch (link.joint) {
    case JointType::revolute:
      s << u.cross(d), u;
      break;
    case JointType::prismatic:
      s << u, Long3(Long3::Zero());
      break;
    case JointType::spherical:
      s << -cross_matrix(d), Long33(Long33::Identity());
  }
  return s;
}

Rates numbers_of(const Link& link, Input values) {
  return values.segment(link.first, rates_of(link.joint)).cast<Real>();
}

Six6 matrix_of(const SpatialInertia& inertia) {
  Six6 I;
  I << inertia.M.cast<Real>(), inertia.H.transpose().cast<Real>(), inertia.H.cast<Real>(),
      inertia.J.cast<Real>();
  return I;
}

}  // namespace

void outward_velocities(const std::vector<Link>& links, Input rates, std::vector<LinkPass>& passes) {
  for (std::size_t i = 1; i < links.size(); ++i) {
    const Link& link = links[i];
    const LinkPass& parent = passes[link.parent];
    // The rates and the parent's velocities do not change here.
    const Moving omega = steady(wide(parent.v.angular)), base = steady(wide(parent.v.linear));
    const Rates rate = numbers_of(link, rates);
    Moving spin = omega, velocity = base;
    if (link.joint == JointType::prismatic) {
      const Moving slide = turning(rate[0] * wide(link.u), omega.now);
      Moving r = turning(wide(link.r), omega.now);
      r.change += slide.now;
      velocity = base + cross(omega, r) + slide;
    } else {
      const Moving turn =
          link.joint == JointType::spherical ? steady(rate) : turning(rate[0] * wide(link.u), omega.now);
      spin = omega + turn;
      velocity = base + cross(omega, turning(wide(link.r) - wide(link.d), omega.now)) +
                 cross(spin, turning(wide(link.d), spin.now));
    }
    passes[i].v = {spin.now.cast<double>(), velocity.now.cast<double>()};
    passes[i].c = {spin.change.cast<double>(), velocity.change.cast<double>()};
    const Long3 momentum = link.tensor.cast<Real>() * spin.now;
    passes[i].bias.force = -link.external.force;
    passes[i].bias.torque = turning(momentum, spin.now).change.cast<double>() - link.external.torque;
  }
}

void inward_inertias(const std::vector<Link>& links, Input Q, std::vector<LinkPass>& passes) {
  std::vector<Six6> I;
  std::vector<Six> Z;
  for (std::size_t i = 0; i < links.size(); ++i) {
    I.push_back(matrix_of(links[i].inertia));
    Z.push_back(six(wide(passes[i].bias.force), wide(passes[i].bias.torque)));
  }
  for (std::size_t i = links.size(); i-- > 0;) {
    passes[i].inertia = {I[i].topLeftCorner<3, 3>().cast<double>(),
                         I[i].bottomLeftCorner<3, 3>().cast<double>(),
                         I[i].bottomRightCorner<3, 3>().cast<double>()};
    passes[i].bias = {Z[i].head<3>().cast<double>(), Z[i].tail<3>().cast<double>()};
    if (i == 0) break;

    const Link& link = links[i];
    const Axes s = axes_of(link), Is = I[i] * s;
    const Eigen::Index count = s.cols();
    const Small D = s.transpose() * Is + link.stiffening.topLeftCorner(count, count).cast<Real>();
    const Eigen::LLT<Small> factor(D);
    passes[i].gain.topLeftCorner(count, count) =
        factor.solve(Small(Small::Identity(count, count))).cast<double>();

    const Six held = Z[i] + I[i] * six(wide(passes[i].c.linear), wide(passes[i].c.angular));
    const Rates pushed = factor.solve(Rates(numbers_of(link, Q) - s.transpose() * held));
    const Eigen::Matrix<Real, Eigen::Dynamic, 6, 0, 3, 6> root =
        factor.matrixL().solve(Is.transpose().eval());
    const Six6 X = carried(link.r);
    I[link.parent] += X.transpose() * (I[i] - root.transpose() * root) * X;
    Z[link.parent] += X.transpose() * (held + Is * pushed);
  }
}

void outward_accelerations(const std::vector<Link>& links, Input Q, std::vector<LinkPass>& passes,
                           Output accelerations) {
  for (std::size_t i = 1; i < links.size(); ++i) {
    const Link& link = links[i];
    const Axes s = axes_of(link);
    const Eigen::Index count = s.cols();
    const SpatialMotion& parent = passes[link.parent].a;
    const Six rigid = carried(link.r) * six(wide(parent.linear), wide(parent.angular)) +
                      six(wide(passes[i].c.linear), wide(passes[i].c.angular));
    const Six force =
        matrix_of(passes[i].inertia) * rigid + six(wide(passes[i].bias.force), wide(passes[i].bias.torque));
    const Rates found = passes[i].gain.topLeftCorner(count, count).cast<Real>() *
                        (numbers_of(link, Q) - s.transpose() * force);
    accelerations.segment(link.first, count) = found.cast<double>();
    const Six a = rigid + s * found;
    passes[i].a = {a.tail<3>().cast<double>(), a.head<3>().cast<double>()};
  }
}

}  // namespace hair
