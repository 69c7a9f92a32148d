// STAFF ONLY. H7: rigid links.
//
// A spherical joint is simplest about its own centre, where s^ = [w; 0]: there s^'I^A s^ is J, and s^'f^ is
// the torque. Passes 2 and 3 calculate with plain numbers, six for a symmetric matrix: compilers keep those
// in registers as long as nothing is called. So large functions are always_inline.

#include "hair/rigid_links.h"

namespace hair {
namespace {

struct Vector {
  double x, y, z;

  Vector(double a, double b, double c) : x(a), y(b), z(c) {}
  template <class Eigens>
  Vector(const Eigen::MatrixBase<Eigens>& v) : x(v[0]), y(v[1]), z(v[2]) {}
  operator Vector3d() const { return {x, y, z}; }
};

inline Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(double s, const Vector& a) {
  return {s * a.x, s * a.y, s * a.z};
}
inline double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline void add(const Vector& a, Vector3d& sum) {
  sum[0] += a.x;
  sum[1] += a.y;
  sum[2] += a.z;
}

struct Symmetric {
  double xx, yx, zx, yy, zy, zz;

  Symmetric(double a, double b, double c, double d, double e, double f)
      : xx(a), yx(b), zx(c), yy(d), zy(e), zz(f) {}
  Symmetric(const Matrix3d& A) : Symmetric(A(0, 0), A(1, 0), A(2, 0), A(1, 1), A(2, 1), A(2, 2)) {}
  Vector x() const { return {xx, yx, zx}; }
  Vector y() const { return {yx, yy, zy}; }
  Vector z() const { return {zx, zy, zz}; }
};

inline Symmetric operator+(const Symmetric& A, const Symmetric& B) {
  return {A.xx + B.xx, A.yx + B.yx, A.zx + B.zx, A.yy + B.yy, A.zy + B.zy, A.zz + B.zz};
}
inline Symmetric operator-(const Symmetric& A, const Symmetric& B) {
  return {A.xx - B.xx, A.yx - B.yx, A.zx - B.zx, A.yy - B.yy, A.zy - B.zy, A.zz - B.zz};
}
inline Vector operator*(const Symmetric& A, const Vector& v) {
  return {dot(A.x(), v), dot(A.y(), v), dot(A.z(), v)};
}
inline Symmetric outer(const Vector& a, const Vector& b) {  // a b^T, where that is symmetric
  return {a.x * b.x, a.y * b.x, a.z * b.x, a.y * b.y, a.z * b.y, a.z * b.z};
}
inline Symmetric inverse(const Symmetric& A) {
  const Vector x = cross(A.y(), A.z()), y = cross(A.z(), A.x());
  const double scale = 1 / dot(A.x(), x), zz = A.xx * A.yy - A.yx * A.yx;
  return {scale * x.x, scale * x.y, scale * x.z, scale * y.y, scale * y.z, scale * zz};
}
inline void put(const Symmetric& A, Matrix3d& result) {
  result << A.xx, A.yx, A.zx, A.yx, A.yy, A.zy, A.zx, A.zy, A.zz;
}

// A matrix by its columns.
struct Columns {
  Vector x, y, z;

  Vector operator*(const Vector& v) const { return v.x * x + v.y * y + v.z * z; }
};
inline Vector transposed(const Columns& A, const Vector& v) {  // A^T v
  return {dot(A.x, v), dot(A.y, v), dot(A.z, v)};
}
inline Columns operator*(const Symmetric& A, const Columns& B) {
  return {A * B.x, A * B.y, A * B.z};
}
inline Symmetric product(const Columns& A, const Columns& B) {  // A^T B, where that is symmetric
  return {dot(A.x, B.x), dot(A.y, B.x), dot(A.z, B.x), dot(A.y, B.y), dot(A.z, B.y), dot(A.z, B.z)};
}

struct Wrench {
  Vector force, torque;
};

struct Inertia {
  Symmetric M;
  Columns H;
  Symmetric J;

  explicit Inertia(const SpatialInertia& inertia)
      : M(inertia.M), H{inertia.H.col(0), inertia.H.col(1), inertia.H.col(2)}, J(inertia.J) {}
  [[gnu::always_inline]] Wrench operator*(const SpatialMotion& m) const {
    const Vector w = m.angular, v = m.linear;
    return {transposed(H, w) + M * v, J * w + H * v};
  }
};

// Makes (i-1)Xi f^ and (i-1)Xi I^ iX(i-1).
[[gnu::always_inline]] inline void shift(const Vector& r, Wrench& f) {
  f.torque = f.torque + cross(r, f.force);
}
[[gnu::always_inline]] inline void shift(const Vector& r, Inertia& I) {
  const Columns rM{cross(r, I.M.x()), cross(r, I.M.y()), cross(r, I.M.z())};
  const Columns sum{2 * I.H.x + rM.x, 2 * I.H.y + rM.y, 2 * I.H.z + rM.z};
  // The rows of (2 H + r~ M) r~.
  const Vector x = cross({sum.x.x, sum.y.x, sum.z.x}, r), y = cross({sum.x.y, sum.y.y, sum.z.y}, r),
               z = cross({sum.x.z, sum.y.z, sum.z.z}, r);
  I.J = I.J - Symmetric(x.x, (x.y + y.x) / 2, (x.z + z.x) / 2, y.y, (y.z + z.y) / 2, z.z);
  I.H = {I.H.x + rM.x, I.H.y + rM.y, I.H.z + rM.z};
}

[[gnu::always_inline]] inline void add(const Wrench& f, const Inertia& I, LinkPass& sum) {
  add(f.force, sum.bias.force);
  add(f.torque, sum.bias.torque);
  const auto add_symmetric = [](const Symmetric& A, Matrix3d& to) {
    to(0, 0) += A.xx, to(1, 0) += A.yx, to(2, 0) += A.zx;
    to(0, 1) += A.yx, to(1, 1) += A.yy, to(2, 1) += A.zy;
    to(0, 2) += A.zx, to(1, 2) += A.zy, to(2, 2) += A.zz;
  };
  add_symmetric(I.M, sum.inertia.M);
  add_symmetric(I.J, sum.inertia.J);
  Matrix3d& H = sum.inertia.H;
  H(0, 0) += I.H.x.x, H(1, 0) += I.H.x.y, H(2, 0) += I.H.x.z;
  H(0, 1) += I.H.y.x, H(1, 1) += I.H.y.y, H(2, 1) += I.H.y.z;
  H(0, 2) += I.H.z.x, H(1, 2) += I.H.z.y, H(2, 2) += I.H.z.z;
}

// s^ of revolute and prismatic joints.
inline SpatialMotion axis(const Link& link) {
  if (link.joint == JointType::prismatic) return {Vector3d::Zero(), link.u};
  return {link.u, link.u.cross(link.d)};
}

// Takes I^A and Z^A + I^A c^, and leaves the brackets of (4.28) and (4.29) in their place: the parts that the
// joint passes on to the parent. Returns 1 / (s^'I^A s^ + b).
[[gnu::always_inline]] inline double let_through(const SpatialMotion& s, double b, double Q, Inertia& I,
                                                 Wrench& f) {
  const Vector w = s.angular, v = s.linear;
  const auto [force, torque] = I * s;
  const double gain = 1 / (dot(v, force) + dot(w, torque) + b);
  const double free = gain * (Q - dot(v, f.force) - dot(w, f.torque));
  f = {f.force + free * force, f.torque + free * torque};
  const Vector part = gain * force;
  I.M = I.M - outer(part, force);
  I.H = {I.H.x - part.x * torque, I.H.y - part.y * torque, I.H.z - part.z * torque};
  I.J = I.J - outer(gain * torque, torque);
  return gain;
}

// The same for a spherical joint, about its centre. With G the gain, J G = 1 - b G.
[[gnu::always_inline]] inline Symmetric let_through(const Symmetric& b, const Vector& Q, Inertia& I,
                                                    Wrench& f) {
  const Symmetric G = inverse(I.J + b);
  const Columns GH = G * I.H, B{b.x(), b.y(), b.z()};
  const Vector turn = G * (Q - f.torque);
  f = {f.force + transposed(I.H, turn), Q - b * turn};
  I.M = I.M - product(I.H, GH);
  I.H = b * GH;
  I.J = b - product(B, G * B);
  return G;
}

// The same without b: the joint passes on only a force, the torque Q and a mass, which make an inertia about
// a point at -r.
[[gnu::always_inline]] inline Symmetric let_through_freely(const Vector& r, const Vector& Q, Inertia& I,
                                                           Wrench& f) {
  const Symmetric G = inverse(I.J);
  f = {f.force + transposed(I.H, G * (Q - f.torque)), Q};
  I.M = I.M - product(I.H, G * I.H);
  I.H = {cross(r, I.M.x()), cross(r, I.M.y()), cross(r, I.M.z())};
  // r~ M r~^T has the rows of r~ M times r~^T.
  const Vector x = cross(r, {I.H.x.x, I.H.y.x, I.H.z.x}), y = cross(r, {I.H.x.y, I.H.y.y, I.H.z.y}),
               z = cross(r, {I.H.x.z, I.H.y.z, I.H.z.z});
  I.J = {x.x, y.x, z.x, y.y, z.y, z.z};
  return G;
}

}  // namespace

void outward_velocities(const std::vector<Link>& links, Input rates, std::vector<LinkPass>& passes) {
  for (std::size_t i = 1; i < links.size(); ++i) {
    const Link& link = links[i];
    const SpatialMotion& parent = passes[link.parent].v;
    const Vector3d& omega = parent.angular;
    LinkPass& pass = passes[i];
    pass.v = to_child(parent, link.r);
    if (link.joint == JointType::prismatic) {
      const Vector3d slide = rates[link.first] * link.u;
      pass.v.linear += slide;
      pass.c = {Vector3d::Zero(), omega.cross(omega.cross(link.r) + 2 * slide)};
    } else {
      const bool spherical = link.joint == JointType::spherical;
      Vector3d w, turned = Vector3d::Zero();
      if (spherical) {
        w = rates.segment<3>(link.first);
      } else {
        w = rates[link.first] * link.u;
        turned = omega.cross(w);
      }
      pass.v += {w, w.cross(link.d)};
      const Vector3d& own = pass.v.angular;
      pass.c = {turned, omega.cross(omega.cross(link.r - link.d)) + turned.cross(link.d) +
                            own.cross(own.cross(link.d))};
    }
    pass.bias.force = -link.external.force;
    const Vector own = pass.v.angular;
    pass.bias.torque = Vector3d(cross(own, Symmetric(link.tensor) * own)) - link.external.torque;
  }
}

void inward_inertias(const std::vector<Link>& links, Input Q, std::vector<LinkPass>& passes) {
  for (std::size_t i = 0; i < links.size(); ++i) passes[i].inertia = links[i].inertia;
  for (std::size_t i = links.size() - 1; i > 0; --i) {
    const Link& link = links[i];
    LinkPass& parent = passes[link.parent];
    LinkPass& pass = passes[i];
    Inertia inertia(pass.inertia);
    Wrench force = inertia * pass.c;
    force = {force.force + pass.bias.force, force.torque + pass.bias.torque};
    if (link.joint == JointType::spherical) {
      shift(link.d, inertia);
      shift(link.d, force);
      const Symmetric b(link.stiffening);
      const Vector from_parent = link.r - link.d, torque = Q.segment<3>(link.first);
      if (b.xx + b.yy + b.zz > 0) {
        put(let_through(b, torque, inertia, force), pass.gain);
        shift(from_parent, inertia);
      } else {
        put(let_through_freely(from_parent, torque, inertia, force), pass.gain);
      }
      shift(from_parent, force);
    } else {
      pass.gain(0, 0) = let_through(axis(link), link.stiffening(0, 0), Q[link.first], inertia, force);
      shift(link.r, inertia);
      shift(link.r, force);
    }
    add(force, inertia, parent);
  }
}

void outward_accelerations(const std::vector<Link>& links, Input Q, std::vector<LinkPass>& passes,
                           Output accelerations) {
  for (std::size_t i = 1; i < links.size(); ++i) {
    const Link& link = links[i];
    LinkPass& pass = passes[i];
    pass.a = to_child(passes[link.parent].a, link.r) + pass.c;
    Wrench force = Inertia(pass.inertia) * pass.a;  // with the joint locked
    force = {force.force + pass.bias.force, force.torque + pass.bias.torque};
    if (link.joint == JointType::spherical) {
      shift(link.d, force);
      const Vector w = Symmetric(pass.gain) * (Vector(Q.segment<3>(link.first)) - force.torque);
      accelerations.segment<3>(link.first) = Vector3d(w);
      add(w, pass.a.angular);
      add(cross(w, link.d), pass.a.linear);
    } else {
      const SpatialMotion s = axis(link);
      const double locked = dot(s.linear, force.force) + dot(s.angular, force.torque);
      accelerations[link.first] = pass.gain(0, 0) * (Q[link.first] - locked);
      pass.a += accelerations[link.first] * s;
    }
  }
}

}  // namespace hair
