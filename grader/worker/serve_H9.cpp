// STAFF ONLY. Serves H9. Each request: function, then by function:
//   0 link_strength          link, largest                            -> a number
//   1 remember_stretches     links, frames, x, largest                -> as many numbers as links
//   2 link_energy            links, frames, largest, x                -> a number
//   3 add_link_force         links, frames, largest, x, f             -> f
//   4 add_link_product       links, largest, dx, df                   -> df
//   5 touch_strip            point, 3 corners, side, thickness, x, tangents  -> 1 and a contact, or 0
//   6 strip_energy           contacts, law, x                         -> a number
//   7 add_strip_force        contacts, law, x, f                      -> f
//   8 add_strip_product      contacts, law, x, dx, df                 -> df
//   9 apply_strip_friction   contacts, law, inverse masses, h, x, v   -> v
#include "grader/wire/mesh_message.h"
#include "grader/worker/guarded_vectors.h"

namespace {

using namespace grader;

GuardedVector get_vector(Session& session) {
  return GuardedVector(session.request.get_doubles());
}

void serve_links(int function, Session& session) {
  MessageReader& request = session.request;
  if (function == 0) {
    const hair::StaticLink link = get_static_link(request);
    const double largest = request.get<double>();
    session.reply.put(session.counted([&] { return hair::link_strength(link, largest); }));
    return;
  }
  const std::vector<hair::StaticLink> links = get_static_links(request);
  const std::vector<hair::Matrix3d> frames =
      function == 4 ? std::vector<hair::Matrix3d>() : get_particle_frames(request);
  GuardedVector first = get_vector(session), second = get_vector(session);
  if (function == 1) {
    session.counted([&] { hair::remember_stretches(links, frames, first.view(), second.view()); });
    session.reply.put(second.values());
  } else if (function == 2) {
    session.reply.put(
        session.counted([&] { return hair::link_energy(links, frames, first.view(), second.view()); }));
  } else {
    GuardedVector result = get_vector(session);
    session.counted([&] {
      if (function == 3)
        hair::add_link_force(links, frames, first.view(), second.view(), result.view());
      else
        hair::add_link_product(links, first.view(), second.view(), result.view());
    });
    session.reply.put(result.values());
  }
}

void serve_touch(Session& session) {
  MessageReader& request = session.request;
  const int point = request.get<int>();
  std::array<int, 3> corners;
  for (int& corner : corners) corner = request.get<int>();
  const double side = request.get<double>(), thickness = request.get<double>();
  GuardedVector x = get_vector(session), tangents = get_vector(session);
  hair::StripContact contact;
  const bool touches = session.counted(
      [&] { return hair::touch_strip(point, corners, side, thickness, x.view(), tangents.view(), contact); });
  session.reply.put(touches ? 1 : 0);
  if (touches) put(session.reply, contact);
}

void serve_strips(int function, Session& session) {
  MessageReader& request = session.request;
  const std::vector<hair::StripContact> contacts = get_strip_contacts(request);
  const hair::StripLaw law = get_strip_law(request);
  GuardedVector first = get_vector(session);
  if (function == 6) {
    session.reply.put(session.counted([&] { return hair::strip_energy(contacts, law, first.view()); }));
    return;
  }
  const double h = function == 9 ? request.get<double>() : 0;
  GuardedVector second = get_vector(session);
  if (function == 7) {
    session.counted([&] { hair::add_strip_force(contacts, law, first.view(), second.view()); });
    session.reply.put(second.values());
    return;
  }
  GuardedVector third = get_vector(session);
  session.counted([&] {
    if (function == 8)
      hair::add_strip_product(contacts, law, first.view(), second.view(), third.view());
    else
      hair::apply_strip_friction(contacts, law, first.view(), h, second.view(), third.view());
  });
  session.reply.put(third.values());
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void serve(grader::Session& session) {
  const int function = session.request.get<int>();
  if (function <= 4)
    serve_links(function, session);
  else if (function == 5)
    serve_touch(session);
  else
    serve_strips(function, session);
}
