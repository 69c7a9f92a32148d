// STAFF ONLY. H9, asked of the student's worker: the requests of grader/worker/serve_H9.cpp. No answer is an index here:
// contacts go back to the worker as it made them.
#include "grader/play/asking.h"
#include "grader/wire/mesh_message.h"
#include "hair/static_links.h"

namespace hair {
namespace {

using grader::MessageReader, grader::MessageWriter;

std::span<const double> sent(Input x) {
  return {x.data(), static_cast<std::size_t>(x.size())};
}

template <class Items>
MessageWriter request_about(int function, const Items& items) {
  MessageWriter request;
  request.put(function);
  grader::put(request, items);
  return request;
}

MessageWriter request_about(int function, std::span<const StaticLink> links,
                            std::span<const Matrix3d> frames) {
  MessageWriter request = request_about(function, links);
  grader::put(request, frames);
  return request;
}

MessageWriter request_about(int function, std::span<const StripContact> contacts, const StripLaw& law) {
  MessageWriter request = request_about(function, contacts);
  grader::put(request, law);
  return request;
}

double asked_number(const MessageWriter& request) {
  MessageReader reply = grader::ask_student(request);
  const double number = reply.get<double>();
  reply.expect_end();
  return number;
}

void ask_to_change(MessageWriter& request, Output& result) {
  MessageReader reply = grader::ask_student(request.put(sent(result)));
  const std::vector<double> numbers = reply.get_doubles(static_cast<std::size_t>(result.size()));
  reply.expect_end();
  result = Eigen::Map<const Eigen::VectorXd>(numbers.data(), result.size());
}

}  // namespace

double link_strength(const StaticLink& link, double largest) {
  return asked_number(request_about(0, link).put(largest));
}

void remember_stretches(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input x,
                        Output largest) {
  ask_to_change(request_about(1, links, frames).put(sent(x)), largest);
}

double link_energy(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input largest,
                   Input x) {
  return asked_number(request_about(2, links, frames).put(sent(largest)).put(sent(x)));
}

void add_link_force(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input largest,
                    Input x, Output f) {
  ask_to_change(request_about(3, links, frames).put(sent(largest)).put(sent(x)), f);
}

void add_link_product(std::span<const StaticLink> links, Input largest, Input dx, Output df) {
  ask_to_change(request_about(4, links).put(sent(largest)).put(sent(dx)), df);
}

bool touch_strip(int point, const std::array<int, 3>& corners, double side, double thickness, Input x,
                 Input tangents, StripContact& contact) {
  MessageWriter request;
  request.put(5).put(point);
  for (const int corner : corners) request.put(corner);
  request.put(side).put(thickness).put(sent(x)).put(sent(tangents));
  MessageReader reply = grader::ask_student(request);
  const bool touches = reply.get<int>() != 0;
  if (touches) contact = grader::get_strip_contact(reply);
  reply.expect_end();
  return touches;
}

double strip_energy(std::span<const StripContact> contacts, const StripLaw& law, Input x) {
  return asked_number(request_about(6, contacts, law).put(sent(x)));
}

void add_strip_force(std::span<const StripContact> contacts, const StripLaw& law, Input x, Output f) {
  ask_to_change(request_about(7, contacts, law).put(sent(x)), f);
}

void add_strip_product(std::span<const StripContact> contacts, const StripLaw& law, Input x, Input dx,
                       Output df) {
  ask_to_change(request_about(8, contacts, law).put(sent(x)).put(sent(dx)), df);
}

void apply_strip_friction(std::span<const StripContact> contacts, const StripLaw& law, Input inverse_mass,
                          double h, Input x, Output v) {
  ask_to_change(request_about(9, contacts, law).put(sent(inverse_mass)).put(h).put(sent(x)), v);
}

}  // namespace hair
