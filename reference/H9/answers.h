// STAFF ONLY. H9's hidden cases: their links, points near triangles and contacts, and a student's answers,
// asked for through the pipe.
#pragma once

#include "grader/judge/cases/case_asker.h"
#include "grader/judge/cases/random.h"
#include "hair/static_links.h"
#include "reference/H9/calls.h"

namespace grader::h9 {

using Eigen::VectorXd;
using hair::Matrix3d, hair::StaticLink, hair::StripContact, hair::StripLaw, hair::Vector3d;

enum class Frames { straight, turned };
enum class Wear { none, some };   // with some, links are new, worn or broken
enum class Pull { little, any };  // with little, no link's stretch reaches `yields`

// Particles within about 5 cm, and links between them of about 1 cm.
struct LinkedHairs {
  std::vector<StaticLink> links;
  std::vector<Matrix3d> frames;
  VectorXd largest, x;

  double size() const;  // the size of a force, N
};
LinkedHairs some_linked_hairs(Random& random, int links, Frames frames, Wear wear, Pull pull);

Vector3d some_direction(Random& random);

// The last of four particles is near the triangle of the first three, which is about 1 cm wide.
struct NearTriangle {
  VectorXd x, tangents;
  double thickness;
};
// `height` is in thicknesses. The barycentric weights `shares` sum to 1.
NearTriangle near_triangle(Random& random, const Vector3d& shares, double height);

// Contacts of a strip with points of other hairs. Corners are shared; points are not. At least one contact
// presses, and one does not.
struct Contacts {
  std::vector<StripContact> contacts;
  StripLaw law;
  VectorXd x, inverse_mass;

  double size() const;  // the size of a force, N
};
Contacts some_contacts(Random& random, int contacts);

// The same in other units of mass and length: powers of 2, which change no digit.
struct Units {
  double mass = 1, length = 1;
};
LinkedHairs in_units(LinkedHairs hairs, const Units& units);
NearTriangle in_units(NearTriangle near, const Units& units);
Contacts in_units(Contacts contacts, const Units& units);

// ---- Answers

inline constexpr auto ask_strength = answer_of<Calls, hair::link_strength>;

inline VectorXd ask_stretches(Trial& trial, const LinkedHairs& hairs) {
  return answer_of<Calls, hair::remember_stretches>(trial, hairs.links, hairs.frames, hairs.x, hairs.largest);
}
inline double ask_link_energy(Trial& trial, const LinkedHairs& hairs) {
  return answer_of<Calls, hair::link_energy>(trial, hairs.links, hairs.frames, hairs.largest, hairs.x);
}
inline VectorXd ask_link_force(Trial& trial, const LinkedHairs& hairs, const VectorXd& f) {
  return answer_of<Calls, hair::add_link_force>(trial, hairs.links, hairs.frames, hairs.largest, hairs.x, f);
}
inline VectorXd ask_link_product(Trial& trial, const LinkedHairs& hairs, const VectorXd& dx,
                                 const VectorXd& df) {
  return answer_of<Calls, hair::add_link_product>(trial, hairs.links, hairs.largest, dx, df);
}
inline std::optional<StripContact> ask_touch(Trial& trial, const NearTriangle& near, double side) {
  const auto [touches, contact] = answer_of<Calls, hair::touch_strip>(
      trial, 3, std::array{0, 1, 2}, side, near.thickness, near.x, near.tangents, StripContact());
  return touches ? std::optional(contact) : std::nullopt;
}
inline double ask_strip_energy(Trial& trial, const Contacts& contacts) {
  return answer_of<Calls, hair::strip_energy>(trial, contacts.contacts, contacts.law, contacts.x);
}
inline VectorXd ask_strip_force(Trial& trial, const Contacts& contacts, const VectorXd& f) {
  return answer_of<Calls, hair::add_strip_force>(trial, contacts.contacts, contacts.law, contacts.x, f);
}
inline VectorXd ask_strip_product(Trial& trial, const Contacts& contacts, const VectorXd& dx,
                                  const VectorXd& df) {
  return answer_of<Calls, hair::add_strip_product>(trial, contacts.contacts, contacts.law, contacts.x, dx,
                                                   df);
}
inline VectorXd ask_friction(Trial& trial, const Contacts& contacts, double h, const VectorXd& v) {
  return answer_of<Calls, hair::apply_strip_friction>(trial, contacts.contacts, contacts.law,
                                                      contacts.inverse_mass, h, contacts.x, v);
}

}  // namespace grader::h9
