// STAFF ONLY. A right solution of H2 that writes down an energy. Dual numbers make the derivatives.

#include "hair/angular_springs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

#include "dual.h"

using std::atan2;
template <class T>
Dual<T> atan2(const Dual<T>& y, const Dual<T>& x) {
  return {atan2(y.v, x.v), (y.d * x.v - y.v * x.d) / (x.v * x.v + y.v * y.v)};
}
double real(double a) {
  return a;
}
template <class T>
double real(const Dual<T>& a) {
  return real(a.v);
}

// phi^2, smooth where phi is 0: (phi / sin)^2 |u1 x u2|^2, with a series of arcsin for the quotient.
template <class T>
T angle_squared(const Vec<T>& e1, const Vec<T>& e2) {
  T l1 = sqrt(dot(e1, e1)), l2 = sqrt(dot(e2, e2));
  Vec<T> a, b;
  for (int i = 0; i < 3; i++) a[i] = e1[i] / l1, b[i] = e2[i] / l2;
  Vec<T> c = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  T sine2 = dot(c, c), cosine = dot(a, b);
  if (real(cosine) > 0.99) {
    T z = T(2) - T(2) * cosine, sum = T(0), power = T(1);
    double factor = 1;
    for (int k = 0; k < 10; k++) {
      sum = sum + T(factor) * power;
      power = power * z;
      factor *= (k + 1) / (4.0 * k + 6);
    }
    return sum * sum * sine2;
  }
  T phi = atan2(sqrt(sine2), cosine);
  return phi * phi;
}

struct Joint {
  Eigen::Vector3d e1, e2;
  double k, s, phi;
  bool nothing;
};

Joint joint_of(const hair::Strand& strand, particles::Input x, int i) {
  Joint j;
  j.e2 = x.segment<3>(3 * i + 3) - x.segment<3>(3 * i);
  if (i == 0) {
    j.e1 = strand.root_tangent;
    j.k = strand.bend_rigidity / (strand.rest_length[0] / 2);
  } else {
    j.e1 = x.segment<3>(3 * i) - x.segment<3>(3 * i - 3);
    j.k = strand.bend_rigidity / ((strand.rest_length[i - 1] + strand.rest_length[i]) / 2);
  }
  j.phi = j.s = 0;
  j.nothing = j.e1.isZero(0) || j.e2.isZero(0);
  if (j.nothing) return j;
  Eigen::Vector3d u1 = j.e1.normalized(), u2 = j.e2.normalized();
  j.s = u1.cross(u2).norm();
  j.phi = std::atan2(j.s, u1.dot(u2));
  j.nothing = j.s == 0 && u1.dot(u2) < 0;
  return j;
}

// Derivatives of the energy k phi^2 / 2 by e1 and e2 (6 numbers), and along a change of them.
void derivatives(const Joint& j, const Eigen::Vector3d& de1, const Eigen::Vector3d& de2, double first[6],
                 double second[6]) {
  for (int n = 0; n < 6; n++) {
    Vec<D2> a, b;
    for (int i = 0; i < 3; i++) {
      a[i] = D2(D1(j.e1[i], n == i), D1(de1[i], 0));
      b[i] = D2(D1(j.e2[i], n == i + 3), D1(de2[i], 0));
    }
    D2 E = D2(j.k / 2) * angle_squared(a, b);
    first[n] = E.v.d;
    second[n] = E.d.d;
  }
}

void add(int i, const double d[6], particles::Output f) {
  Eigen::Map<const Eigen::Vector3d> d1(d), d2(d + 3);
  if (i > 0) {
    f.segment<3>(3 * i - 3) += d1;
    f.segment<3>(3 * i) -= d1;
  }
  f.segment<3>(3 * i) += d2;
  f.segment<3>(3 * i + 3) -= d2;
}

Eigen::Vector3d change(particles::Input dx, int i) {
  if (i < 0) return Eigen::Vector3d::Zero();
  return dx.segment<3>(3 * i + 3) - dx.segment<3>(3 * i);
}

}  // namespace

namespace hair {

double bend_energy(const Strand& strand, Input x) {
  double E = 0;
  for (int i = strand.clamped ? 0 : 1; i < strand.segments(); i++) {
    Joint j = joint_of(strand, x, i);
    E += j.k * j.phi * j.phi / 2;
  }
  return E;
}

void add_bend_force(const Strand& strand, Input x, Output f) {
  double first[6], second[6];
  for (int i = strand.clamped ? 0 : 1; i < strand.segments(); i++) {
    Joint j = joint_of(strand, x, i);
    if (j.nothing) continue;
    derivatives(j, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), first, second);
    add(i, first, f);
  }
}

void add_bend_product(const Strand& strand, Input x, Input dx, Output df) {
  double first[6], second[6];
  for (int i = strand.clamped ? 0 : 1; i < strand.segments(); i++) {
    Joint j = joint_of(strand, x, i);
    if (j.nothing) continue;
    derivatives(j, change(dx, i - 1), change(dx, i), first, second);
    add(i, second, df);
  }
}

void add_bend_product_spd(const Strand& strand, Input x, Input dx, Output df) {
  for (int i = strand.clamped ? 0 : 1; i < strand.segments(); i++) {
    Joint j = joint_of(strand, x, i);
    if (j.nothing) continue;
    double l1 = j.e1.norm(), l2 = j.e2.norm();
    Eigen::Vector3d u1 = j.e1 / l1, u2 = j.e2 / l2, t = (u1 + u2).normalized(), c = u1.cross(u2);
    c -= t * t.dot(c);
    Eigen::Vector3d b = c.isZero(0) ? t.unitOrthogonal() : c.normalized();
    // Two rows of a 2 x 6 matrix, S = rows^T k rows.
    Eigen::Matrix<double, 2, 6> rows;
    double p = j.s > 0 ? std::max(j.phi * u1.dot(u2) / j.s, 0.0) : 1;
    rows << -b.cross(u1).transpose() / l1, b.cross(u2).transpose() / l2, -std::sqrt(p) * b.transpose() / l1,
        std::sqrt(p) * b.transpose() / l2;
    Eigen::Matrix<double, 6, 1> de, d;
    de << change(dx, i - 1), change(dx, i);
    d = j.k * rows.transpose() * (rows * de);
    add(i, d.data(), df);
  }
}

}  // namespace hair
