// STAFF ONLY.
#include "grader/suite/H9/answers.h"

#include "grader/suite/numbers.h"

namespace grader::h9 {
namespace {

MessageWriter about(Trial& trial, int function, const LinkedHairs& hairs) {
  trial.describe(std::to_string(hairs.links.size()) + " links between " +
                 std::to_string(hairs.frames.size()) + " particles");
  MessageWriter message;
  message.put(function);
  put(message, hairs.links);
  return message;
}

MessageWriter about(Trial& trial, int function, const Contacts& contacts) {
  trial.describe(std::to_string(contacts.contacts.size()) + " contacts, " +
                 std::to_string(contacts.x.size() / 3) + " particles");
  MessageWriter message;
  message.put(function);
  put(message, contacts.contacts);
  put(message, contacts.law);
  return message;
}

// Asks for what becomes of `before`, the last argument.
VectorXd ask_changed(Trial& trial, MessageWriter& message, const VectorXd& before) {
  return only_numbers(ask_alone(trial, message.put(as_numbers(before))), before.size());
}

}  // namespace

double ask_strength(Trial& trial, const StaticLink& link, double largest) {
  MessageWriter message;
  message.put(0);
  put(message, link);
  message.put(largest);
  trial.describe("yields " + std::to_string(link.yields) + ", breaks " + std::to_string(link.breaks) +
                 ", largest " + std::to_string(largest));
  return only_number(ask_alone(trial, message));
}

VectorXd ask_stretches(Trial& trial, const LinkedHairs& hairs) {
  MessageWriter message = about(trial, 1, hairs);
  put(message, hairs.frames);
  return ask_changed(trial, message.put(as_numbers(hairs.x)), hairs.largest);
}

double ask_link_energy(Trial& trial, const LinkedHairs& hairs) {
  MessageWriter message = about(trial, 2, hairs);
  put(message, hairs.frames);
  message.put(as_numbers(hairs.largest)).put(as_numbers(hairs.x));
  return only_number(ask_alone(trial, message));
}

VectorXd ask_link_force(Trial& trial, const LinkedHairs& hairs, const VectorXd& before) {
  MessageWriter message = about(trial, 3, hairs);
  put(message, hairs.frames);
  return ask_changed(trial, message.put(as_numbers(hairs.largest)).put(as_numbers(hairs.x)), before);
}

VectorXd ask_link_product(Trial& trial, const LinkedHairs& hairs, const VectorXd& dx,
                          const VectorXd& before) {
  MessageWriter message = about(trial, 4, hairs);
  return ask_changed(trial, message.put(as_numbers(hairs.largest)).put(as_numbers(dx)), before);
}

std::optional<StripContact> ask_touch(Trial& trial, const NearTriangle& near, double side) {
  MessageWriter message;
  message.put(5).put(3).put(0).put(1).put(2).put(side).put(near.thickness);
  message.put(as_numbers(near.x)).put(as_numbers(near.tangents));
  MessageReader reply = ask_alone(trial, message);
  if (reply.get<int>() == 0) {
    reply.expect_end();
    return {};
  }
  const StripContact contact = get_strip_contact(reply);
  reply.expect_end();
  return contact;
}

double ask_strip_energy(Trial& trial, const Contacts& contacts) {
  MessageWriter message = about(trial, 6, contacts);
  message.put(as_numbers(contacts.x));
  return only_number(ask_alone(trial, message));
}

VectorXd ask_strip_force(Trial& trial, const Contacts& contacts, const VectorXd& before) {
  MessageWriter message = about(trial, 7, contacts);
  return ask_changed(trial, message.put(as_numbers(contacts.x)), before);
}

VectorXd ask_strip_product(Trial& trial, const Contacts& contacts, const VectorXd& dx,
                           const VectorXd& before) {
  MessageWriter message = about(trial, 8, contacts);
  return ask_changed(trial, message.put(as_numbers(contacts.x)).put(as_numbers(dx)), before);
}

VectorXd ask_friction(Trial& trial, const Contacts& contacts, double h, const VectorXd& v) {
  MessageWriter message = about(trial, 9, contacts);
  message.put(as_numbers(contacts.inverse_mass)).put(h);
  return ask_changed(trial, message.put(as_numbers(contacts.x)), v);
}

}  // namespace grader::h9
