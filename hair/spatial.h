// Spatial vectors: the motion of a rigid link, and the force on it, as six numbers. Source: the lecture,
// "Featherstone Algorithm"; B. Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems" (PhD thesis,
// Berkeley 1996), chapter 4.
//
//   velocity      v^ = [omega; v]    rad/s,   m/s      acceleration  a^ = [alpha; a]   rad/s^2, m/s^2
//   force         f^ = [f; tau]      N,       N m      (as Mirtich has them: the halves change places)
//
// Those of link i refer to its centre of mass: v and a are the velocity and the acceleration of this point,
// tau is the torque about it. All components are along the axes of the world. So Mirtich's transform between
// two links needs no rotation, only the vector r from the one centre of mass to the other:
//
//   iX(i-1) = [  1    0 ]     (i-1)Xi = [ 1   0 ]     r~ x = r x x,  r = r_i, from link i-1 to link i
//             [ -r~   1 ]               [ r~  1 ]
//
// Motions and forces are different types, so that the compiler refuses to mix them up.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace hair {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct SpatialMotion {
  Vector3d angular = Vector3d::Zero();
  Vector3d linear = Vector3d::Zero();

  SpatialMotion& operator+=(const SpatialMotion& other) {
    angular += other.angular;
    linear += other.linear;
    return *this;
  }
};

inline SpatialMotion operator+(SpatialMotion a, const SpatialMotion& b) {
  return a += b;
}
inline SpatialMotion operator*(double factor, const SpatialMotion& m) {
  return {factor * m.angular, factor * m.linear};
}

struct SpatialForce {
  Vector3d force = Vector3d::Zero();
  Vector3d torque = Vector3d::Zero();

  SpatialForce& operator+=(const SpatialForce& other) {
    force += other.force;
    torque += other.torque;
    return *this;
  }
};

inline SpatialForce operator+(SpatialForce a, const SpatialForce& b) {
  return a += b;
}
inline SpatialForce operator*(double factor, const SpatialForce& f) {
  return {factor * f.force, factor * f.torque};
}

// s^' f^, the prime being Mirtich's spatial transpose, [a; b]' = [b^T a^T]: the power of the force, if s^ is
// a velocity.
inline double dot(const SpatialMotion& s, const SpatialForce& f) {
  return s.linear.dot(f.force) + s.angular.dot(f.torque);
}

// Inertia: f = H^T alpha + M a, tau = J alpha + H a. M and J are symmetric. A single link has M = m 1, H = 0
// and J its inertia tensor.
//
// As a matrix on [alpha; a] this is Mirtich's I^ = [ H^T M ]
//                                                  [ J   H ].
struct SpatialInertia {
  Matrix3d M = Matrix3d::Zero();  // kg
  Matrix3d H = Matrix3d::Zero();  // kg m
  Matrix3d J = Matrix3d::Zero();  // kg m^2

  SpatialInertia& operator+=(const SpatialInertia& other) {
    M += other.M;
    H += other.H;
    J += other.J;
    return *this;
  }
};

inline SpatialForce operator*(const SpatialInertia& inertia, const SpatialMotion& m) {
  return {inertia.H.transpose() * m.angular + inertia.M * m.linear,
          inertia.J * m.angular + inertia.H * m.linear};
}

// I^ += factor f^ f^'. With the factor -1 / s^'I^s^ and f^ = I^s^ this is the fraction in (4.28).
inline void add_product(double factor, const SpatialForce& f, SpatialInertia& inertia) {
  const Vector3d force = factor * f.force, torque = factor * f.torque;
  inertia.M.noalias() += force * f.force.transpose();
  inertia.H.noalias() += torque * f.force.transpose();
  inertia.J.noalias() += torque * f.torque.transpose();
}

// iX(i-1) v^: the motion of link i if it is one body with link i-1; r from link i-1 to link i.
inline SpatialMotion to_child(const SpatialMotion& m, const Vector3d& r) {
  return {m.angular, m.linear - r.cross(m.angular)};
}

// (i-1)Xi f^: the same force, with its torque about link i-1's centre of mass; the same r.
inline SpatialForce to_parent(const SpatialForce& f, const Vector3d& r) {
  return {f.force, f.torque + r.cross(f.force)};
}

// (i-1)Xi I^ iX(i-1), the same r:  H becomes H + r~ M, and J becomes J - (N + N^T) / 2 with N = (2 H + r~ M)
// r~.
inline SpatialInertia to_parent(const SpatialInertia& inertia, const Vector3d& r) {
  Matrix3d rM, N;
  for (int k = 0; k < 3; ++k) rM.col(k) = r.cross(inertia.M.col(k));
  const Matrix3d sum = 2 * inertia.H + rM;
  for (int k = 0; k < 3; ++k) N.row(k) = sum.row(k).cross(r);
  return {inertia.M, inertia.H + rM, inertia.J - (N + N.transpose()) / 2};
}

}  // namespace hair
