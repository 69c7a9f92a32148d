// STAFF ONLY. H9: static links and triangle strips.

#include "hair/static_links.h"

#include <algorithm>
#include <cmath>

namespace hair {
namespace {

Vector3d particle(Input x, int i) {
  return x.segment<3>(3 * Eigen::Index{i});
}

Vector3d displacement(const StaticLink& link, std::span<const Matrix3d> frames, Input x) {
  return particle(x, link.b) - particle(x, link.a) - frames[link.a] * link.offset;
}

// k s.
double worn_stiffness(const StaticLink& link, double largest) {
  return link.stiffness * link_strength(link, largest);
}

// The point's part of a vector less its projection's.
Vector3d relative_to_strip(const StripContact& contact, Input x) {
  Vector3d relative = particle(x, contact.point);
  for (int j = 0; j < 3; ++j) relative -= contact.shares[j] * particle(x, contact.corners[j]);
  return relative;
}

void add_shared(const StripContact& contact, const Vector3d& force, Output f) {
  f.segment<3>(3 * Eigen::Index{contact.point}) += force;
  for (int j = 0; j < 3; ++j) f.segment<3>(3 * Eigen::Index{contact.corners[j]}) -= contact.shares[j] * force;
}

double depth(const StripContact& contact, const StripLaw& law, Input x) {
  return std::max(0.0, law.thickness - contact.normal.dot(relative_to_strip(contact, x)));
}

}  // namespace

double link_strength(const StaticLink& link, double largest) {
  if (largest <= link.yields) return 1;
  if (largest >= link.breaks) return 0;
  return (link.breaks - largest) / (link.breaks - link.yields);
}

void remember_stretches(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input x,
                        Output largest) {
  for (std::size_t l = 0; l < links.size(); ++l) {
    double& most = largest[static_cast<Eigen::Index>(l)];
    most = std::max(most, displacement(links[l], frames, x).norm() / links[l].length);
  }
}

double link_energy(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input largest,
                   Input x) {
  double energy = 0;
  for (std::size_t l = 0; l < links.size(); ++l)
    energy += worn_stiffness(links[l], largest[static_cast<Eigen::Index>(l)]) *
              displacement(links[l], frames, x).squaredNorm() / 2;
  return energy;
}

void add_link_force(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input largest,
                    Input x, Output f) {
  for (std::size_t l = 0; l < links.size(); ++l) {
    const Vector3d force =
        -worn_stiffness(links[l], largest[static_cast<Eigen::Index>(l)]) * displacement(links[l], frames, x);
    f.segment<3>(3 * Eigen::Index{links[l].b}) += force;
    f.segment<3>(3 * Eigen::Index{links[l].a}) -= force;
  }
}

void add_link_product(std::span<const StaticLink> links, Input largest, Input dx, Output df) {
  for (std::size_t l = 0; l < links.size(); ++l) {
    const Vector3d force = -worn_stiffness(links[l], largest[static_cast<Eigen::Index>(l)]) *
                           (particle(dx, links[l].b) - particle(dx, links[l].a));
    df.segment<3>(3 * Eigen::Index{links[l].b}) += force;
    df.segment<3>(3 * Eigen::Index{links[l].a}) -= force;
  }
}

bool touch_strip(int point, const std::array<int, 3>& corners, double side, double thickness, Input x,
                 Input tangents, StripContact& contact) {
  const Vector3d corner = particle(x, corners[0]), to_1 = particle(x, corners[1]) - corner,
                 to_2 = particle(x, corners[2]) - corner, to_point = particle(x, point) - corner;
  const Vector3d area = to_1.cross(to_2);
  const double size = area.norm();
  if (size == 0) return false;
  const Vector3d normal = area / size;
  if (std::abs(normal.dot(to_point)) >= thickness) return false;
  const double of_1 = normal.dot(to_point.cross(to_2)) / size, of_2 = normal.dot(to_1.cross(to_point)) / size;
  contact = {point, corners, {1 - of_1 - of_2, of_1, of_2}, side * normal, 1};
  const Vector3d tangent = particle(tangents, point);
  for (int j = 0; j < 3; ++j) {
    if (contact.shares[j] < 0) return false;
    contact.weight -= contact.shares[j] * std::abs(tangent.dot(particle(tangents, corners[j])));
  }
  contact.weight = std::max(0.0, contact.weight);
  return true;
}

double strip_energy(std::span<const StripContact> contacts, const StripLaw& law, Input x) {
  double energy = 0;
  for (const StripContact& contact : contacts) {
    const double deep = depth(contact, law, x);
    energy += law.stiffness * contact.weight * deep * deep / 2;
  }
  return energy;
}

void add_strip_force(std::span<const StripContact> contacts, const StripLaw& law, Input x, Output f) {
  for (const StripContact& contact : contacts)
    add_shared(contact, law.stiffness * contact.weight * depth(contact, law, x) * contact.normal, f);
}

void add_strip_product(std::span<const StripContact> contacts, const StripLaw& law, Input x, Input dx,
                       Output df) {
  for (const StripContact& contact : contacts) {
    if (depth(contact, law, x) == 0) continue;
    const double opening = contact.normal.dot(relative_to_strip(contact, dx));
    add_shared(contact, -law.stiffness * contact.weight * opening * contact.normal, df);
  }
}

void apply_strip_friction(std::span<const StripContact> contacts, const StripLaw& law, Input inverse_mass,
                          double h, Input x, Output v) {
  for (const StripContact& contact : contacts) {
    Vector3d slip = relative_to_strip(contact, v);
    slip -= contact.normal.dot(slip) * contact.normal;
    double inverse = inverse_mass[contact.point];
    for (int j = 0; j < 3; ++j)
      inverse += contact.shares[j] * contact.shares[j] * inverse_mass[contact.corners[j]];
    const double speed = slip.norm();
    if (speed == 0 || inverse == 0) continue;
    const double pressure = law.stiffness * contact.weight * depth(contact, law, x);
    const Vector3d impulse = -std::min(law.friction * pressure * h, speed / inverse) / speed * slip;
    v.segment<3>(3 * Eigen::Index{contact.point}) += inverse_mass[contact.point] * impulse;
    for (int j = 0; j < 3; ++j)
      v.segment<3>(3 * Eigen::Index{contact.corners[j]}) -=
          contact.shares[j] * inverse_mass[contact.corners[j]] * impulse;
  }
}

}  // namespace hair
