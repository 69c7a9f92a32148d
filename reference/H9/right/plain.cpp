// STAFF ONLY. H9 as the text has it: each formula as it stands there.
#include "hair/static_links.h"

#include <cmath>

namespace hair {

static Vector3d at(Input x, int i) {
  return Vector3d(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
}

static void add(Output f, int i, const Vector3d& force) {
  f.segment<3>(3 * i) += force;
}

double link_strength(const StaticLink& link, double largest) {
  if (largest <= link.yields) return 1;
  if (largest >= link.breaks) return 0;
  return 1 - (largest - link.yields) / (link.breaks - link.yields);
}

void remember_stretches(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input x,
                        Output largest) {
  int l = 0;
  for (const StaticLink& link : links) {
    const Vector3d d = at(x, link.b) - (at(x, link.a) + frames[link.a] * link.offset);
    const double stretch = d.norm() / link.length;
    if (stretch > largest[l]) largest[l] = stretch;
    ++l;
  }
}

double link_energy(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input largest,
                   Input x) {
  double E = 0;
  int l = 0;
  for (const StaticLink& link : links) {
    const Vector3d d = at(x, link.b) - (at(x, link.a) + frames[link.a] * link.offset);
    E += link.stiffness * link_strength(link, largest[l]) * d.dot(d) / 2;
    ++l;
  }
  return E;
}

void add_link_force(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input largest,
                    Input x, Output f) {
  int l = 0;
  for (const StaticLink& link : links) {
    const Vector3d d = at(x, link.b) - (at(x, link.a) + frames[link.a] * link.offset);
    const Vector3d force = -link.stiffness * link_strength(link, largest[l]) * d;
    add(f, link.b, force);
    add(f, link.a, -force);
    ++l;
  }
}

void add_link_product(std::span<const StaticLink> links, Input largest, Input dx, Output df) {
  int l = 0;
  for (const StaticLink& link : links) {
    const Vector3d force =
        -link.stiffness * link_strength(link, largest[l]) * (at(dx, link.b) - at(dx, link.a));
    add(df, link.b, force);
    add(df, link.a, -force);
    ++l;
  }
}

bool touch_strip(int point, const std::array<int, 3>& corners, double side, double thickness, Input x,
                 Input tangents, StripContact& contact) {
  const Vector3d x0 = at(x, corners[0]), x1 = at(x, corners[1]), x2 = at(x, corners[2]), p = at(x, point);
  const Vector3d N = (x1 - x0).cross(x2 - x0);
  if (N.norm() == 0) return false;
  const Vector3d n = N.normalized();
  if (std::abs(n.dot(p - x0)) >= thickness) return false;
  contact.point = point;
  contact.corners = corners;
  contact.normal = side * n;
  // Each is an area over the whole triangle's.
  contact.shares[0] = N.dot((x1 - p).cross(x2 - p)) / N.squaredNorm();
  contact.shares[1] = N.dot((x2 - p).cross(x0 - p)) / N.squaredNorm();
  contact.shares[2] = N.dot((x0 - p).cross(x1 - p)) / N.squaredNorm();
  for (const double share : contact.shares)
    if (share < 0) return false;
  double aligned = 0;
  for (int j = 0; j < 3; ++j)
    aligned += contact.shares[j] * std::abs(at(tangents, point).dot(at(tangents, corners[j])));
  contact.weight = aligned < 1 ? 1 - aligned : 0;
  return true;
}

// The point's part of x less its projection's.
static Vector3d from_foot(const StripContact& contact, Input x) {
  Vector3d foot = Vector3d::Zero();
  for (int j = 0; j < 3; ++j) foot += contact.shares[j] * at(x, contact.corners[j]);
  return at(x, contact.point) - foot;
}

double strip_energy(std::span<const StripContact> contacts, const StripLaw& law, Input x) {
  double E = 0;
  for (const StripContact& contact : contacts) {
    const double g = contact.normal.dot(from_foot(contact, x));
    if (g < law.thickness)
      E += law.stiffness * contact.weight * (law.thickness - g) * (law.thickness - g) / 2;
  }
  return E;
}

void add_strip_force(std::span<const StripContact> contacts, const StripLaw& law, Input x, Output f) {
  for (const StripContact& contact : contacts) {
    const double g = contact.normal.dot(from_foot(contact, x));
    if (g >= law.thickness) continue;
    const double p = law.stiffness * contact.weight * (law.thickness - g);
    add(f, contact.point, p * contact.normal);
    for (int j = 0; j < 3; ++j) add(f, contact.corners[j], -contact.shares[j] * p * contact.normal);
  }
}

void add_strip_product(std::span<const StripContact> contacts, const StripLaw& law, Input x, Input dx,
                       Output df) {
  for (const StripContact& contact : contacts) {
    const double g = contact.normal.dot(from_foot(contact, x));
    if (g >= law.thickness) continue;
    const double dg = contact.normal.dot(from_foot(contact, dx));
    const double dp = -law.stiffness * contact.weight * dg;
    add(df, contact.point, dp * contact.normal);
    for (int j = 0; j < 3; ++j) add(df, contact.corners[j], -contact.shares[j] * dp * contact.normal);
  }
}

void apply_strip_friction(std::span<const StripContact> contacts, const StripLaw& law, Input inverse_mass,
                          double h, Input x, Output v) {
  for (const StripContact& contact : contacts) {
    const Vector3d n = contact.normal;
    const double g = n.dot(from_foot(contact, x));
    if (g >= law.thickness) continue;
    const double p = law.stiffness * contact.weight * (law.thickness - g);
    const Vector3d relative = from_foot(contact, v);
    const Vector3d u = relative - n * n.dot(relative);
    double W = inverse_mass[contact.point];
    for (int j = 0; j < 3; ++j) W += contact.shares[j] * contact.shares[j] * inverse_mass[contact.corners[j]];
    if (W == 0 || u.norm() == 0) continue;
    double J = law.friction * p * h;
    if (J > u.norm() / W) J = u.norm() / W;
    const Vector3d impulse = -J * u.normalized();
    add(v, contact.point, inverse_mass[contact.point] * impulse);
    for (int j = 0; j < 3; ++j)
      add(v, contact.corners[j], -contact.shares[j] * inverse_mass[contact.corners[j]] * impulse);
  }
}

}  // namespace hair
