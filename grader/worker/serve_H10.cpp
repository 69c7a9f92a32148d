// STAFF ONLY. Serves H10. Each request: function, then by function:
//   0 root_weights   3 corners, root                     -> 3 numbers
//   1 interpolate    3 guides, 3 weights, root frame     -> 3n numbers
//   2 carry_along    3n numbers                          -> frames
//   3 extrapolate    3n numbers, frames, root, spread    -> 3n numbers
//   4 blend          arc, 3n and 3n numbers, and where the child goes: 0 elsewhere, 1 at_root, 2 at_tip
//                                                        -> 3n numbers
#include "grader/wire/helix_message.h"
#include "grader/wire/synthesis_message.h"
#include "grader/worker/guarded_vectors.h"

namespace {

using namespace grader;

// A guide whose points end in front of a protected page.
struct GuardedGuide {
  explicit GuardedGuide(const OwnGuide& own)
      : root(own.root), points(std::vector<double>(own.points.begin(), own.points.end())) {}
  hair::GuideHair view() { return {root, {points.view().data(), points.view().size()}}; }

  hair::RootFrame root;
  GuardedVector points;
};

std::vector<double> get_points(Session& session) {
  std::vector<double> numbers = session.request.get_doubles();
  if (numbers.size() < 6 || numbers.size() % 3 != 0) throw MalformedMessage("no line of points");
  return numbers;
}

void reply_points(Session& session, GuardedScratch& child) {
  session.reply.put(std::span<const double>(child.view().data(), child.view().size()));
}

void of_weights(Session& session) {
  std::array<hair::Vector3d, 3> corners;
  for (hair::Vector3d& corner : corners) corner = get_vector3(session.request);
  const hair::Vector3d root = get_vector3(session.request);
  const std::array<double, 3> weights = session.counted([&] { return hair::root_weights(corners, root); });
  session.reply.put(std::span<const double>(weights));
}

void of_interpolation(Session& session) {
  GuardedGuide first(get_guide(session.request)), second(get_guide(session.request)),
      third(get_guide(session.request));
  const Eigen::Index size = first.points.view().size();
  if (second.points.view().size() != size || third.points.view().size() != size)
    throw MalformedMessage("guides of different numbers of points");
  const std::vector<double> weights = session.request.get_doubles(3);
  const hair::RootFrame root = get_root_frame(session.request);
  GuardedScratch child(static_cast<int>(size), 1);
  session.counted([&] {
    hair::interpolate({first.view(), second.view(), third.view()}, {weights[0], weights[1], weights[2]}, root,
                      child.view().col(0));
  });
  reply_points(session, child);
}

void of_frames(Session& session) {
  GuardedVector guide(get_points(session));
  const Eigen::Index points = guide.view().size() / 3;
  hair::GuideFrames frames{
      Eigen::VectorXd::Constant(points, std::nan("")),
      std::vector<hair::Matrix3d>(static_cast<std::size_t>(points), hair::Matrix3d::Constant(std::nan("")))};
  session.counted([&] { hair::carry_along(guide.view(), frames); });
  frames.arc.conservativeResize(points);
  frames.turns.resize(static_cast<std::size_t>(points));
  put(session.reply, frames);
}

void of_extrapolation(Session& session) {
  GuardedVector guide(get_points(session));
  const Eigen::Index size = guide.view().size();
  const hair::GuideFrames frames = get_guide_frames(session.request, static_cast<std::size_t>(size / 3));
  const hair::Vector3d root = get_vector3(session.request);
  const double spread = session.request.get<double>();
  GuardedScratch child(static_cast<int>(size), 1);
  session.counted([&] { hair::extrapolate(guide.view(), frames, root, spread, child.view().col(0)); });
  reply_points(session, child);
}

void of_blend(Session& session) {
  const std::vector<double> numbers = session.request.get_doubles();
  GuardedVector arc(numbers), at_root(session.request.get_doubles(3 * numbers.size())),
      at_tip(session.request.get_doubles(3 * numbers.size()));
  const int where = session.request.get<int>();
  GuardedScratch elsewhere(static_cast<int>(3 * numbers.size()), 1);
  particles::Output child = where == 1   ? particles::Output(at_root.view())
                            : where == 2 ? particles::Output(at_tip.view())
                                         : particles::Output(elsewhere.view().col(0));
  session.counted([&] { hair::blend(arc.view(), at_root.view(), at_tip.view(), child); });
  session.reply.put(std::span<const double>(child.data(), child.size()));
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void serve(grader::Session& session) {
  const int function = session.request.get<int>();
  if (function == 0)
    of_weights(session);
  else if (function == 1)
    of_interpolation(session);
  else if (function == 2)
    of_frames(session);
  else if (function == 3)
    of_extrapolation(session);
  else
    of_blend(session);
}
