// STAFF ONLY. A right solution of H9 in which every link and every contact is a row of weights of particles:
// its displacement is the row times their places, and forces go back by the same weights. It uses long
// double, and barycentric weights from a system of 2 x 2.

#include "hair/static_links.h"

#include <cmath>

namespace hair {
namespace {

using Real = long double;
using Vector = Eigen::Matrix<Real, 3, 1>;

struct Entry {
  int particle;
  Real weight;
};

Vector get(Input x, int particle) {
  return Vector(x[3 * particle], x[3 * particle + 1], x[3 * particle + 2]);
}

template <std::size_t n>
Vector gather(const std::array<Entry, n>& row, Input x) {
  Vector sum = Vector::Zero();
  for (const Entry& entry : row) sum += entry.weight * get(x, entry.particle);
  return sum;
}

template <std::size_t n>
void scatter(const std::array<Entry, n>& row, const Vector& v, Output to) {
  for (const Entry& entry : row)
    for (int k = 0; k < 3; ++k) to[3 * entry.particle + k] += static_cast<double>(entry.weight * v[k]);
}

std::array<Entry, 2> row_of(const StaticLink& link) {
  return {{{link.b, 1}, {link.a, -1}}};
}

std::array<Entry, 4> row_of(const StripContact& contact) {
  std::array<Entry, 4> row;
  row[0] = {contact.point, 1};
  for (int j = 0; j < 3; ++j) row[j + 1] = {contact.corners[j], -static_cast<Real>(contact.shares[j])};
  return row;
}

Vector displacement(const StaticLink& link, std::span<const Matrix3d> frames, Input x) {
  return gather(row_of(link), x) - frames[link.a].cast<Real>() * link.offset.cast<Real>();
}

// The point's depth within the thickness. It does not press at 0 or less.
Real depth(const StripContact& contact, const StripLaw& law, Input x) {
  return law.thickness - contact.normal.cast<Real>().dot(gather(row_of(contact), x));
}

}  // namespace

double link_strength(const StaticLink& link, double largest) {
  if (largest <= link.yields) return 1;
  if (largest >= link.breaks) return 0;
  return (link.breaks - largest) / (link.breaks - link.yields);
}

void remember_stretches(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input x,
                        Output largest) {
  for (std::size_t l = links.size(); l-- > 0;) {
    const Real stretch = displacement(links[l], frames, x).norm() / links[l].length;
    largest[l] = std::fmax(largest[l], static_cast<double>(stretch));
  }
}

double link_energy(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input largest,
                   Input x) {
  Real twice = 0;
  for (std::size_t l = 0; l < links.size(); ++l)
    twice += links[l].stiffness * static_cast<Real>(link_strength(links[l], largest[l])) *
             displacement(links[l], frames, x).squaredNorm();
  return static_cast<double>(twice / 2);
}

void add_link_force(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input largest,
                    Input x, Output f) {
  for (std::size_t l = 0; l < links.size(); ++l) {
    const Real stiffness = links[l].stiffness * static_cast<Real>(link_strength(links[l], largest[l]));
    if (stiffness > 0) scatter(row_of(links[l]), -stiffness * displacement(links[l], frames, x), f);
  }
}

void add_link_product(std::span<const StaticLink> links, Input largest, Input dx, Output df) {
  for (std::size_t l = 0; l < links.size(); ++l) {
    const Real stiffness = links[l].stiffness * static_cast<Real>(link_strength(links[l], largest[l]));
    if (stiffness > 0) scatter(row_of(links[l]), -stiffness * gather(row_of(links[l]), dx), df);
  }
}

// The projection is x_0 + s (x_1 - x_0) + t (x_2 - x_0), with s and t from normal equations.
bool touch_strip(int point, const std::array<int, 3>& corners, double side, double thickness, Input x,
                 Input tangents, StripContact& contact) {
  const Vector a = get(x, corners[1]) - get(x, corners[0]), b = get(x, corners[2]) - get(x, corners[0]),
               p = get(x, point) - get(x, corners[0]), N = a.cross(b);
  const Real area = N.norm();
  if (area == 0) return false;
  const Vector n = N / area;
  if (std::abs(n.dot(p)) >= thickness) return false;
  const Vector across = n.cross(a), along = n.cross(b);
  const Real s = along.dot(p) / along.dot(a), t = across.dot(p) / across.dot(b);
  const Real shares[] = {1 - s - t, s, t};
  Real aligned = 0;
  for (int j = 0; j < 3; ++j) {
    contact.shares[j] = static_cast<double>(shares[j]);
    if (contact.shares[j] < 0) return false;
    aligned += shares[j] * std::abs(get(tangents, corners[j]).dot(get(tangents, point)));
  }
  contact.point = point;
  contact.corners = corners;
  contact.normal = (side * n).cast<double>();
  contact.weight = static_cast<double>(std::fmax(0.0L, 1 - aligned));
  return true;
}

double strip_energy(std::span<const StripContact> contacts, const StripLaw& law, Input x) {
  Real sum = 0;
  for (const StripContact& contact : contacts) {
    const Real deep = std::fmax(0.0L, depth(contact, law, x));
    sum += contact.weight * deep * deep;
  }
  return static_cast<double>(law.stiffness * sum / 2);
}

void add_strip_force(std::span<const StripContact> contacts, const StripLaw& law, Input x, Output f) {
  for (const StripContact& contact : contacts) {
    const Real deep = depth(contact, law, x);
    if (deep > 0)
      scatter(row_of(contact), law.stiffness * contact.weight * deep * contact.normal.cast<Real>(), f);
  }
}

void add_strip_product(std::span<const StripContact> contacts, const StripLaw& law, Input x, Input dx,
                       Output df) {
  for (const StripContact& contact : contacts) {
    if (depth(contact, law, x) <= 0) continue;
    const Vector n = contact.normal.cast<Real>();
    scatter(row_of(contact), -law.stiffness * contact.weight * n.dot(gather(row_of(contact), dx)) * n, df);
  }
}

void apply_strip_friction(std::span<const StripContact> contacts, const StripLaw& law, Input inverse_mass,
                          double h, Input x, Output v) {
  for (const StripContact& contact : contacts) {
    const Real deep = depth(contact, law, x);
    if (deep <= 0) continue;
    std::array<Entry, 4> row = row_of(contact);
    const Vector n = contact.normal.cast<Real>(), moves = gather(row, v), slip = moves - n.dot(moves) * n;
    Real W = 0;
    for (const Entry& entry : row) W += entry.weight * entry.weight * inverse_mass[entry.particle];
    const Real speed = slip.norm();
    if (W == 0 || speed == 0) continue;
    const Real impulse = std::fmin(law.friction * law.stiffness * contact.weight * deep * h, speed / W);
    for (Entry& entry : row) entry.weight *= inverse_mass[entry.particle];
    scatter(row, -impulse / speed * slip, v);
  }
}

}  // namespace hair
