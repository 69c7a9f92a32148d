// STAFF ONLY. H10, asked of the student's worker: the requests of grader/worker/serve_H10.cpp.
#include "grader/play/asking.h"
#include "grader/wire/helix_message.h"
#include "grader/wire/synthesis_message.h"

namespace hair {
namespace {

using grader::MessageReader, grader::MessageWriter;

std::span<const double> line_of(Input points) {
  return {points.data(), static_cast<std::size_t>(points.size())};
}

void ask_for_child(const MessageWriter& request, Output& child) {
  MessageReader reply = grader::ask_student(request);
  const std::vector<double> numbers = reply.get_doubles(static_cast<std::size_t>(child.size()));
  reply.expect_end();
  child = Eigen::Map<const Eigen::VectorXd>(numbers.data(), child.size());
}

}  // namespace

std::array<double, 3> root_weights(const std::array<Vector3d, 3>& corners, const Vector3d& root) {
  MessageWriter request;
  request.put(0);
  for (const Vector3d& corner : corners) grader::put_vector3(request, corner);
  grader::put_vector3(request, root);
  MessageReader reply = grader::ask_student(request);
  const std::vector<double> weights = reply.get_doubles(3);
  reply.expect_end();
  return {weights[0], weights[1], weights[2]};
}

void interpolate(const std::array<GuideHair, 3>& guides, const std::array<double, 3>& weights,
                 const RootFrame& root, Output child) {
  MessageWriter request;
  request.put(1);
  for (const GuideHair& guide : guides)
    grader::put(request, grader::OwnGuide{guide.root, Eigen::VectorXd(guide.points)});
  request.put(std::span<const double>(weights));
  grader::put(request, root);
  ask_for_child(request, child);
}

void carry_along(Input guide, GuideFrames& frames) {
  MessageWriter request;
  MessageReader reply = grader::ask_student(request.put(2).put(line_of(guide)));
  frames = grader::get_guide_frames(reply, frames.turns.size());
  reply.expect_end();
}

void extrapolate(Input guide, const GuideFrames& frames, const Vector3d& root, double spread, Output child) {
  MessageWriter request;
  request.put(3).put(line_of(guide));
  grader::put(request, frames);
  grader::put_vector3(request, root);
  ask_for_child(request.put(spread), child);
}

// Here `child` may be one of the two: the worker is told which, so that it sees what a simulation would show it.
void blend(Input arc, Input at_root, Input at_tip, Output child) {
  const int where = child.data() == at_root.data() ? 1 : child.data() == at_tip.data() ? 2 : 0;
  MessageWriter request;
  request.put(4).put(line_of(arc)).put(line_of(at_root)).put(line_of(at_tip)).put(where);
  ask_for_child(request, child);
}

}  // namespace hair
