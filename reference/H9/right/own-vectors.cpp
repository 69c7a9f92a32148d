// STAFF ONLY. H9 without Eigen's vectors: arrays of three, a contact's four particles as a list of coefficients, shares from a
// linear system of two unknowns, links from the last to the first.
#include "hair/static_links.h"

#include <algorithm>
#include <cmath>

namespace hair {
namespace {

struct Three {
  double x, y, z;
};

Three operator+(Three a, Three b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Three operator-(Three a, Three b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Three operator*(double s, Three a) {
  return {s * a.x, s * a.y, s * a.z};
}
double dot(Three a, Three b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Three cross(Three a, Three b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(Three a) {
  return std::hypot(a.x, a.y, a.z);
}
Three load(Input x, int i) {
  const double* numbers = x.data() + 3 * static_cast<std::ptrdiff_t>(i);
  return {numbers[0], numbers[1], numbers[2]};
}
void add(double* numbers, int i, Three a) {
  numbers += 3 * static_cast<std::ptrdiff_t>(i);
  numbers[0] += a.x;
  numbers[1] += a.y;
  numbers[2] += a.z;
}

Three pulled(const StaticLink& link, std::span<const Matrix3d> frames, Input x) {
  const Matrix3d& R = frames[link.a];
  const Three o{link.offset[0], link.offset[1], link.offset[2]};
  const Three turned{dot({R(0, 0), R(0, 1), R(0, 2)}, o), dot({R(1, 0), R(1, 1), R(1, 2)}, o),
                     dot({R(2, 0), R(2, 1), R(2, 2)}, o)};
  return (load(x, link.b) - load(x, link.a)) - turned;
}

double left(const StaticLink& link, double largest) {
  return link_strength(link, largest) * link.stiffness;
}

// The point and the corners, each with its part of the gap.
struct Lever {
  int particle;
  double part;
};
using Levers = std::array<Lever, 4>;

Levers levers_of(const StripContact& c) {
  return {{{c.corners[2], -c.shares[2]},
           {c.corners[1], -c.shares[1]},
           {c.corners[0], -c.shares[0]},
           {c.point, 1}}};
}

Three sum(const Levers& levers, Input x) {
  Three all{0, 0, 0};
  for (const Lever& lever : levers) all = all + lever.part * load(x, lever.particle);
  return all;
}

Three normal_of(const StripContact& c) {
  return {c.normal[0], c.normal[1], c.normal[2]};
}

// k w (r - g), 0 if it does not press.
double pressure(const StripContact& c, const StripLaw& law, Input x) {
  const double deep = law.thickness - dot(normal_of(c), sum(levers_of(c), x));
  return deep > 0 ? law.stiffness * c.weight * deep : 0;
}

}  // namespace

double link_strength(const StaticLink& link, double largest) {
  if (!(largest > link.yields)) return 1;
  return std::max(0.0, largest < link.breaks ? (link.breaks - largest) / (link.breaks - link.yields) : 0.0);
}

void remember_stretches(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input x,
                        Output largest) {
  for (std::size_t l = links.size(); l-- > 0;) {
    const double now = length(pulled(links[l], frames, x)) / links[l].length;
    if (now > largest.data()[l]) largest.data()[l] = now;
  }
}

double link_energy(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input largest,
                   Input x) {
  double twice = 0;
  for (std::size_t l = links.size(); l-- > 0;) {
    const Three d = pulled(links[l], frames, x);
    twice += left(links[l], largest.data()[l]) * dot(d, d);
  }
  return twice / 2;
}

void add_link_force(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input largest,
                    Input x, Output f) {
  for (std::size_t l = links.size(); l-- > 0;) {
    const Three force = left(links[l], largest.data()[l]) * pulled(links[l], frames, x);
    add(f.data(), links[l].a, force);
    add(f.data(), links[l].b, -1 * force);
  }
}

void add_link_product(std::span<const StaticLink> links, Input largest, Input dx, Output df) {
  for (std::size_t l = links.size(); l-- > 0;) {
    const Three force = left(links[l], largest.data()[l]) * (load(dx, links[l].b) - load(dx, links[l].a));
    add(df.data(), links[l].a, force);
    add(df.data(), links[l].b, -1 * force);
  }
}

bool touch_strip(int point, const std::array<int, 3>& corners, double side, double thickness, Input x,
                 Input tangents, StripContact& contact) {
  const Three origin = load(x, corners[2]), a = load(x, corners[0]) - origin,
              b = load(x, corners[1]) - origin, p = load(x, point) - origin;
  const Three area = cross(a, b);
  const double size = length(area);
  if (!(size > 0)) return false;
  const Three n = (1 / size) * area;
  if (std::abs(dot(n, p)) >= thickness) return false;
  // p = s a + t b in the plane: normal equations.
  const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), ap = dot(a, p), bp = dot(b, p);
  const double determinant = size * size;
  const double s = (ap * bb - bp * ab) / determinant, t = (bp * aa - ap * ab) / determinant;
  if (s < 0 || t < 0 || s + t > 1) return false;
  contact.point = point;
  contact.corners = corners;
  contact.shares = {s, t, 1 - s - t};
  contact.normal = Vector3d(side * n.x, side * n.y, side * n.z);
  double crossing = 0;
  for (int j = 0; j < 3; ++j)
    crossing += contact.shares[j] * (1 - std::abs(dot(load(tangents, point), load(tangents, corners[j]))));
  contact.weight = std::max(0.0, crossing);
  return true;
}

double strip_energy(std::span<const StripContact> contacts, const StripLaw& law, Input x) {
  double energy = 0;
  for (const StripContact& c : contacts) {
    const double deep = std::max(0.0, law.thickness - dot(normal_of(c), sum(levers_of(c), x)));
    energy += c.weight * deep * deep;
  }
  return law.stiffness * energy / 2;
}

void add_strip_force(std::span<const StripContact> contacts, const StripLaw& law, Input x, Output f) {
  for (std::size_t i = contacts.size(); i-- > 0;) {
    const Three push = pressure(contacts[i], law, x) * normal_of(contacts[i]);
    for (const Lever& lever : levers_of(contacts[i])) add(f.data(), lever.particle, lever.part * push);
  }
}

void add_strip_product(std::span<const StripContact> contacts, const StripLaw& law, Input x, Input dx,
                       Output df) {
  for (std::size_t i = contacts.size(); i-- > 0;) {
    const StripContact& c = contacts[i];
    const Levers levers = levers_of(c);
    const Three n = normal_of(c);
    if (!(dot(n, sum(levers, x)) < law.thickness)) continue;
    const double change = law.stiffness * c.weight * dot(n, sum(levers, dx));
    for (const Lever& lever : levers) add(df.data(), lever.particle, -lever.part * change * n);
  }
}

void apply_strip_friction(std::span<const StripContact> contacts, const StripLaw& law, Input inverse_mass,
                          double h, Input x, Output v) {
  for (const StripContact& c : contacts) {
    const Levers levers = levers_of(c);
    double W = 0;
    for (const Lever& lever : levers) W += lever.part * lever.part * inverse_mass.data()[lever.particle];
    const Three n = normal_of(c), relative = sum(levers, v), u = relative - dot(n, relative) * n;
    const double speed = length(u);
    if (!(W > 0) || !(speed > 0)) continue;
    const double slowed = std::min(law.friction * pressure(c, law, x) * h * W, speed);
    for (const Lever& lever : levers)
      add(v.data(), lever.particle,
          -(lever.part * inverse_mass.data()[lever.particle] / W * (slowed / speed)) * u);
  }
}

}  // namespace hair
