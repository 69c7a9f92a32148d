// STAFF ONLY. Serves H8. Each request: function, then by function:
//   0 stumpff            x                                        -> 8 numbers
//   1 frame_at           start, curvature, s                      -> frame
//   2 carry_frames       root, elements                           -> elements
//   3 helix_stiffness    strand                                   -> 3n numbers
//   4 elastic_force      strand, q                                -> 3n numbers
//   5 jacobian_at        start, curvature, s                      -> Jacobian
//   6 generalised_force  elements, points                         -> 3n numbers
//   7 mass_matrix        elements, points                         -> 3n x 3n numbers
//   8 helix_step         strand, elements, points, q, rates, h    -> 3n numbers
#include "grader/wire/helix_message.h"
#include "grader/worker/guarded_vectors.h"
#include "hair/super_helix.h"

namespace {

using namespace grader;

void of_a_place(int function, Session& session) {
  const hair::MaterialFrame start = get_frame(session.request);
  const hair::Vector3d curvature = get_vector3(session.request);
  const double s = session.request.get<double>();
  if (function == 1)
    put(session.reply, hair::frame_at(start, curvature, s));
  else
    put(session.reply, hair::jacobian_at(start, curvature, s));
}

void of_all_frames(Session& session) {
  const hair::MaterialFrame root = get_frame(session.request);
  std::vector<hair::HelixElement> elements = get_elements(session.request);
  const std::size_t count = elements.size();
  hair::carry_frames(root, elements);
  elements.resize(count);
  put(session.reply, elements);
}

void of_elasticity(int function, Session& session) {
  const hair::HelixStrand strand = get_helix_strand(session.request);
  const int size = 3 * strand.elements();
  GuardedScratch result(size, 1);
  if (function == 3) {
    hair::helix_stiffness(strand, result.view().col(0));
  } else {
    GuardedVector q(session.request.get_doubles(size));
    hair::elastic_force(strand, q.view(), result.view().col(0));
  }
  session.reply.put(std::span<const double>(result.view().data(), size));
}

void of_all_points(int function, Session& session) {
  const std::vector<hair::HelixElement> elements = get_elements(session.request);
  const std::vector<hair::HelixPoint> points = get_points(session.request, elements.size());
  const int size = 3 * static_cast<int>(elements.size());
  GuardedScratch result(size, function == 6 ? 1 : size);
  if (function == 6)
    hair::generalised_force(elements, points, result.view().col(0));
  else
    hair::mass_matrix(elements, points, result.view());
  session.reply.put(std::span<const double>(result.view().data(), result.view().size()));
}

void of_a_step(Session& session) {
  const hair::HelixStrand strand = get_helix_strand(session.request);
  const std::vector<hair::HelixElement> elements = get_elements(session.request);
  if (static_cast<int>(elements.size()) != strand.elements())
    throw MalformedMessage("elements of another strand");
  const std::vector<hair::HelixPoint> points = get_points(session.request, elements.size());
  const int size = 3 * strand.elements();
  GuardedVector q(session.request.get_doubles(size)), rates(session.request.get_doubles(size));
  const double h = session.request.get<double>();
  GuardedScratch scratch(size, size + 10), change(size, 1);
  session.counted([&] {
    hair::helix_step(strand, elements, points, q.view(), rates.view(), h, scratch.view(),
                     change.view().col(0));
  });
  session.reply.put(std::span<const double>(change.view().data(), size));
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void serve(grader::Session& session) {
  const int function = session.request.get<int>();
  if (function == 0) {
    const std::array<double, 8> c = hair::stumpff(session.request.get<double>());
    session.reply.put(std::span<const double>(c));
  } else if (function == 1 || function == 5) {
    of_a_place(function, session);
  } else if (function == 2) {
    of_all_frames(session);
  } else if (function == 3 || function == 4) {
    of_elasticity(function, session);
  } else if (function == 6 || function == 7) {
    of_all_points(function, session);
  } else {
    of_a_step(session);
  }
}
