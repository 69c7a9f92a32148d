// STAFF ONLY. A right solution of H9 that writes down energies. Dual numbers make the forces, and dual
// numbers of dual numbers the products.
#include "hair/static_links.h"

#include <cmath>

namespace hair {
namespace {

#include "dual.h"

// The energy k s |x_b - (x_a + arm)|^2 / 2; `of` holds a and b.
struct LinkEnergy {
  std::array<int, 2> of;
  double stiffness;
  Vector3d arm;

  template <typename T>
  T operator()(const std::array<Vec<T>, 2>& x) const {
    T sum = 0;
    for (int k = 0; k < 3; ++k) {
      const T d = x[1][k] - (x[0][k] + T(arm[k]));
      sum = sum + d * d;
    }
    return T(stiffness / 2) * sum;
  }
};

// The energy k w max(0, r - g)^2 / 2; `of` holds the point and the corners.
struct StripEnergy {
  const StripContact& contact;
  const StripLaw& law;
  std::array<int, 4> of = {contact.point, contact.corners[0], contact.corners[1], contact.corners[2]};

  template <typename T>
  T gap(const std::array<Vec<T>, 4>& x) const {
    T g = 0;
    for (int k = 0; k < 3; ++k) {
      T foot = 0;
      for (int j = 0; j < 3; ++j) foot = foot + T(contact.shares[j]) * x[j + 1][k];
      g = g + T(contact.normal[k]) * (x[0][k] - foot);
    }
    return g;
  }
  template <typename T>
  T operator()(const std::array<Vec<T>, 4>& x) const {
    const T depth = T(law.thickness) - gap(x);
    return T(law.stiffness * contact.weight / 2) * (depth * depth);
  }
};

// The particles of an energy, made of each number by `number(value)`.
template <typename T, std::size_t n, typename Number>
std::array<Vec<T>, n> corners(const std::array<int, n>& of, const Number& number) {
  std::array<Vec<T>, n> x;
  for (std::size_t j = 0; j < n; ++j)
    for (int k = 0; k < 3; ++k) x[j][k] = number(3 * of[j] + k);
  return x;
}

template <typename Energy>
double value(const Energy& energy, Input x) {
  return energy(corners<double>(energy.of, [&](int i) { return x[i]; }));
}

template <typename Energy>
void subtract_gradient(const Energy& energy, Input x, Output f) {
  auto at = corners<D1>(energy.of, [&](int i) { return D1(x[i], 0); });
  for (std::size_t j = 0; j < at.size(); ++j)
    for (int k = 0; k < 3; ++k) {
      at[j][k].d = 1;
      f[3 * energy.of[j] + k] -= energy(at).d;
      at[j][k].d = 0;
    }
}

// A quadratic energy has the same second derivatives everywhere, so they are taken at 0.
template <typename Energy>
void subtract_product(const Energy& energy, Input dx, Output df) {
  auto at = corners<D2>(energy.of, [&](int i) { return D2(D1(0, 0), D1(dx[i], 0)); });
  for (std::size_t j = 0; j < at.size(); ++j)
    for (int k = 0; k < 3; ++k) {
      at[j][k].v.d = 1;
      df[3 * energy.of[j] + k] -= energy(at).d.d;
      at[j][k].v.d = 0;
    }
}

LinkEnergy energy_of(const StaticLink& link, double largest, const Vector3d& arm) {
  return {{link.a, link.b}, link.stiffness * link_strength(link, largest), arm};
}

bool touches(const StripEnergy& energy, Input x) {
  return energy.gap(corners<double>(energy.of, [&](int i) { return x[i]; })) < energy.law.thickness;
}

Vector3d at(Input x, int i) {
  return x.segment<3>(3 * i);
}

}  // namespace

double link_strength(const StaticLink& link, double largest) {
  if (!(largest > link.yields)) return 1;
  return largest < link.breaks ? (link.breaks - largest) / (link.breaks - link.yields) : 0;
}

void remember_stretches(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input x,
                        Output largest) {
  for (std::size_t l = links.size(); l-- > 0;) {
    const StaticLink& link = links[l];
    const LinkEnergy twice{{link.a, link.b}, 2, frames[link.a] * link.offset};
    const auto i = static_cast<Eigen::Index>(l);
    largest[i] = std::fmax(largest[i], std::sqrt(value(twice, x)) / link.length);
  }
}

double link_energy(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input largest,
                   Input x) {
  double sum = 0;
  for (std::size_t l = 0; l < links.size(); ++l)
    sum += value(
        energy_of(links[l], largest[static_cast<Eigen::Index>(l)], frames[links[l].a] * links[l].offset), x);
  return sum;
}

void add_link_force(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input largest,
                    Input x, Output f) {
  for (std::size_t l = 0; l < links.size(); ++l)
    subtract_gradient(
        energy_of(links[l], largest[static_cast<Eigen::Index>(l)], frames[links[l].a] * links[l].offset), x,
        f);
}

void add_link_product(std::span<const StaticLink> links, Input largest, Input dx, Output df) {
  for (std::size_t l = 0; l < links.size(); ++l)
    subtract_product(energy_of(links[l], largest[static_cast<Eigen::Index>(l)], Vector3d::Zero()), dx, df);
}

// The barycentric weights are coordinates along the first edge, and in the plane across it.
bool touch_strip(int point, const std::array<int, 3>& corners, double side, double thickness, Input x,
                 Input tangents, StripContact& contact) {
  const Vector3d origin = at(x, corners[0]), a = at(x, corners[1]) - origin, b = at(x, corners[2]) - origin,
                 p = at(x, point) - origin, N = a.cross(b);
  const double area = N.norm();
  if (area == 0) return false;
  const Vector3d n = N / area, along = a.normalized(), across = n.cross(along);
  if (!(std::fabs(n.dot(p)) < thickness)) return false;
  const double share_b = p.dot(across) / b.dot(across),
               share_a = (p.dot(along) - share_b * b.dot(along)) / a.norm();
  contact = {point, corners, {1 - share_a - share_b, share_a, share_b}, side * n, 1};
  for (int j = 0; j < 3; ++j) {
    if (contact.shares[j] < 0) return false;
    contact.weight -= contact.shares[j] * std::fabs(at(tangents, point).dot(at(tangents, corners[j])));
  }
  contact.weight = std::fmax(contact.weight, 0);
  return true;
}

double strip_energy(std::span<const StripContact> contacts, const StripLaw& law, Input x) {
  double sum = 0;
  for (const StripContact& contact : contacts) {
    const StripEnergy energy{contact, law};
    if (touches(energy, x)) sum += value(energy, x);
  }
  return sum;
}

void add_strip_force(std::span<const StripContact> contacts, const StripLaw& law, Input x, Output f) {
  for (const StripContact& contact : contacts) {
    const StripEnergy energy{contact, law};
    if (touches(energy, x)) subtract_gradient(energy, x, f);
  }
}

void add_strip_product(std::span<const StripContact> contacts, const StripLaw& law, Input x, Input dx,
                       Output df) {
  for (const StripContact& contact : contacts) {
    const StripEnergy energy{contact, law};
    if (touches(energy, x)) subtract_product(energy, dx, df);
  }
}

// The pressure is the energy's loss for each metre that the gap grows.
void apply_strip_friction(std::span<const StripContact> contacts, const StripLaw& law, Input inverse_mass,
                          double h, Input x, Output v) {
  for (const StripContact& contact : contacts) {
    const StripEnergy energy{contact, law};
    if (!touches(energy, x)) continue;
    const double gap = energy.gap(corners<double>(energy.of, [&](int i) { return x[i]; }));
    const double pressure = law.stiffness * contact.weight * (law.thickness - gap);
    const std::array<double, 4> factors = {1, -contact.shares[0], -contact.shares[1], -contact.shares[2]};
    Vector3d slip = Vector3d::Zero();
    double W = 0;
    for (int j = 0; j < 4; ++j) {
      slip += factors[j] * at(v, energy.of[j]);
      W += factors[j] * factors[j] * inverse_mass[energy.of[j]];
    }
    const Vector3d& n = contact.normal;
    slip = n.cross(slip).cross(n);
    const double speed = slip.norm();
    if (W == 0 || speed == 0) continue;
    const double impulse = std::fmin(law.friction * pressure * h, speed / W);
    for (int j = 0; j < 4; ++j)
      v.segment<3>(3 * energy.of[j]) -= factors[j] * inverse_mass[energy.of[j]] * impulse / speed * slip;
  }
}

}  // namespace hair
