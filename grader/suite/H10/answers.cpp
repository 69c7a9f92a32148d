// STAFF ONLY.
#include "grader/suite/H10/answers.h"

#include "grader/suite/numbers.h"
#include "grader/wire/helix_message.h"

namespace grader::h10 {
namespace {

std::string points_of(const VectorXd& guide) {
  return std::to_string(guide.size() / 3) + " points";
}

}  // namespace

Weights ask_weights(Trial& trial, const Corners& corners, const Vector3d& root) {
  MessageWriter message;
  message.put(0);
  for (const Vector3d& corner : corners) put_vector3(message, corner);
  put_vector3(message, root);
  const VectorXd weights = only_numbers(ask_alone(trial, message), 3);
  return {weights[0], weights[1], weights[2]};
}

VectorXd ask_interpolated(Trial& trial, const std::array<OwnGuide, 3>& guides, const Weights& weights,
                          const RootFrame& root) {
  MessageWriter message;
  message.put(1);
  for (const OwnGuide& guide : guides) put(message, guide);
  message.put(std::span<const double>(weights));
  put(message, root);
  trial.describe("guides of " + points_of(guides[0].points) + ", weights " + std::to_string(weights[0]) +
                 ", " + std::to_string(weights[1]) + ", " + std::to_string(weights[2]));
  return only_numbers(ask_alone(trial, message), guides[0].points.size());
}

GuideFrames ask_frames(Trial& trial, const VectorXd& guide) {
  MessageWriter message;
  message.put(2);
  message.put(as_numbers(guide));
  trial.describe("a guide of " + points_of(guide));
  MessageReader reply = ask_alone(trial, message);
  GuideFrames frames = get_guide_frames(reply, static_cast<std::size_t>(guide.size() / 3));
  reply.expect_end();
  return frames;
}

VectorXd ask_extrapolated(Trial& trial, const VectorXd& guide, const GuideFrames& frames,
                          const Vector3d& root, double spread) {
  MessageWriter message;
  message.put(3);
  message.put(as_numbers(guide));
  put(message, frames);
  put_vector3(message, root);
  message.put(spread);
  trial.describe("a guide of " + points_of(guide) + ", spread " + std::to_string(spread));
  return only_numbers(ask_alone(trial, message), guide.size());
}

VectorXd ask_blended(Trial& trial, const VectorXd& arc, const VectorXd& at_root, const VectorXd& at_tip,
                     Place place) {
  MessageWriter message;
  message.put(4).put(as_numbers(arc)).put(as_numbers(at_root)).put(as_numbers(at_tip));
  message.put(static_cast<int>(place));
  trial.describe(std::to_string(arc.size()) + " points, into " +
                 (place == Place::own       ? "memory of its own"
                  : place == Place::at_root ? "at_root"
                                            : "at_tip"));
  return only_numbers(ask_alone(trial, message), at_root.size());
}

}  // namespace grader::h10
