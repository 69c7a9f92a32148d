// STAFF ONLY. Asks a student's functions of H9 through the pipe.
#pragma once

#include "grader/judge/cases/case_asker.h"
#include "reference/H9/calls.h"
#include "reference/H9/mesh.h"

namespace grader::h9 {

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
