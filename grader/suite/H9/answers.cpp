// STAFF ONLY.
#include "grader/suite/H9/answers.h"

namespace grader::h9 {
namespace {

MessageReader ask(Trial& trial, const MessageWriter& message) {
  return trial.ask(message, [](int, const auto&, auto&) -> bool { throw MalformedMessage("no operator"); });
}

double only_number(MessageReader reply) {
  const auto number = reply.get<double>();
  reply.expect_end();
  return number;
}

VectorXd only_numbers(MessageReader reply, Eigen::Index size) {
  const std::vector<double> numbers = reply.get_doubles(static_cast<std::size_t>(size));
  reply.expect_end();
  return Eigen::Map<const VectorXd>(numbers.data(), size);
}

std::span<const double> as_numbers(const VectorXd& vector) {
  return {vector.data(), static_cast<std::size_t>(vector.size())};
}

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

}  // namespace

double ask_strength(Trial& trial, const StaticLink& link, double largest) {
  MessageWriter message;
  message.put(0);
  put(message, link);
  message.put(largest);
  trial.describe("yields " + std::to_string(link.yields) + ", breaks " + std::to_string(link.breaks) +
                 ", largest " + std::to_string(largest));
  return only_number(ask(trial, message));
}

VectorXd ask_stretches(Trial& trial, const LinkedHairs& hairs) {
  MessageWriter message = about(trial, 1, hairs);
  put(message, hairs.frames);
  message.put(as_numbers(hairs.x)).put(as_numbers(hairs.largest));
  return only_numbers(ask(trial, message), hairs.largest.size());
}

double ask_link_energy(Trial& trial, const LinkedHairs& hairs) {
  MessageWriter message = about(trial, 2, hairs);
  put(message, hairs.frames);
  message.put(as_numbers(hairs.largest)).put(as_numbers(hairs.x));
  return only_number(ask(trial, message));
}

VectorXd ask_link_force(Trial& trial, const LinkedHairs& hairs, const VectorXd& before) {
  MessageWriter message = about(trial, 3, hairs);
  put(message, hairs.frames);
  message.put(as_numbers(hairs.largest)).put(as_numbers(hairs.x)).put(as_numbers(before));
  return only_numbers(ask(trial, message), before.size());
}

VectorXd ask_link_product(Trial& trial, const LinkedHairs& hairs, const VectorXd& dx,
                          const VectorXd& before) {
  MessageWriter message = about(trial, 4, hairs);
  message.put(as_numbers(hairs.largest)).put(as_numbers(dx)).put(as_numbers(before));
  return only_numbers(ask(trial, message), before.size());
}

std::optional<StripContact> ask_touch(Trial& trial, const NearTriangle& near, double side) {
  MessageWriter message;
  message.put(5).put(3).put(0).put(1).put(2).put(side).put(near.thickness);
  message.put(as_numbers(near.x)).put(as_numbers(near.tangents));
  MessageReader reply = ask(trial, message);
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
  return only_number(ask(trial, message));
}

VectorXd ask_strip_force(Trial& trial, const Contacts& contacts, const VectorXd& before) {
  MessageWriter message = about(trial, 7, contacts);
  message.put(as_numbers(contacts.x)).put(as_numbers(before));
  return only_numbers(ask(trial, message), before.size());
}

VectorXd ask_strip_product(Trial& trial, const Contacts& contacts, const VectorXd& dx,
                           const VectorXd& before) {
  MessageWriter message = about(trial, 8, contacts);
  message.put(as_numbers(contacts.x)).put(as_numbers(dx)).put(as_numbers(before));
  return only_numbers(ask(trial, message), before.size());
}

VectorXd ask_friction(Trial& trial, const Contacts& contacts, double h, const VectorXd& v) {
  MessageWriter message = about(trial, 9, contacts);
  message.put(as_numbers(contacts.inverse_mass)).put(h);
  message.put(as_numbers(contacts.x)).put(as_numbers(v));
  return only_numbers(ask(trial, message), v.size());
}

}  // namespace grader::h9
