// STAFF ONLY. Asks a student's functions of H9.
#include "reference/H9/answers.h"

#include "grader/judge/case_asker.h"
#include "reference/H9/calls.h"

namespace grader::h9 {
namespace {

void describe(Trial& trial, const LinkedHairs& hairs) {
  trial.describe(std::to_string(hairs.links.size()) + " links between " +
                 std::to_string(hairs.frames.size()) + " particles");
}

void describe(Trial& trial, const Contacts& contacts) {
  trial.describe(std::to_string(contacts.contacts.size()) + " contacts, " +
                 std::to_string(contacts.x.size() / 3) + " particles");
}

}  // namespace

double ask_strength(Trial& trial, const StaticLink& link, double largest) {
  trial.describe("yields " + std::to_string(link.yields) + ", breaks " + std::to_string(link.breaks) +
                 ", largest " + std::to_string(largest));
  return ask_student_for<Calls, hair::link_strength>(trial, link, largest);
}

VectorXd ask_stretches(Trial& trial, const LinkedHairs& hairs) {
  describe(trial, hairs);
  VectorXd largest = hairs.largest;
  ask_student_for<Calls, hair::remember_stretches>(trial, hairs.links, hairs.frames, hairs.x, largest);
  return largest;
}

double ask_link_energy(Trial& trial, const LinkedHairs& hairs) {
  describe(trial, hairs);
  return ask_student_for<Calls, hair::link_energy>(trial, hairs.links, hairs.frames, hairs.largest, hairs.x);
}

VectorXd ask_link_force(Trial& trial, const LinkedHairs& hairs, VectorXd f) {
  describe(trial, hairs);
  ask_student_for<Calls, hair::add_link_force>(trial, hairs.links, hairs.frames, hairs.largest, hairs.x, f);
  return f;
}

VectorXd ask_link_product(Trial& trial, const LinkedHairs& hairs, const VectorXd& dx, VectorXd df) {
  describe(trial, hairs);
  ask_student_for<Calls, hair::add_link_product>(trial, hairs.links, hairs.largest, dx, df);
  return df;
}

std::optional<StripContact> ask_touch(Trial& trial, const NearTriangle& near, double side) {
  constexpr std::array<int, 3> kCorners{0, 1, 2};
  StripContact contact;
  const bool touches = ask_student_for<Calls, hair::touch_strip>(trial, 3, kCorners, side, near.thickness,
                                                                 near.x, near.tangents, contact);
  return touches ? std::optional(contact) : std::nullopt;
}

double ask_strip_energy(Trial& trial, const Contacts& contacts) {
  describe(trial, contacts);
  return ask_student_for<Calls, hair::strip_energy>(trial, contacts.contacts, contacts.law, contacts.x);
}

VectorXd ask_strip_force(Trial& trial, const Contacts& contacts, VectorXd f) {
  describe(trial, contacts);
  ask_student_for<Calls, hair::add_strip_force>(trial, contacts.contacts, contacts.law, contacts.x, f);
  return f;
}

VectorXd ask_strip_product(Trial& trial, const Contacts& contacts, const VectorXd& dx, VectorXd df) {
  describe(trial, contacts);
  ask_student_for<Calls, hair::add_strip_product>(trial, contacts.contacts, contacts.law, contacts.x, dx, df);
  return df;
}

VectorXd ask_friction(Trial& trial, const Contacts& contacts, double h, VectorXd v) {
  describe(trial, contacts);
  ask_student_for<Calls, hair::apply_strip_friction>(trial, contacts.contacts, contacts.law,
                                                     contacts.inverse_mass, h, contacts.x, v);
  return v;
}

}  // namespace grader::h9
