// STAFF ONLY.
#include "grader/wire/synthesis_message.h"

#include <algorithm>

#include "grader/wire/helix_message.h"

namespace grader {
namespace {

Eigen::VectorXd as_vector(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

std::span<const double> as_span(const Eigen::VectorXd& vector) {
  return {vector.data(), static_cast<std::size_t>(vector.size())};
}

}  // namespace

void put(MessageWriter& message, const hair::RootFrame& frame) {
  for (const hair::Vector3d& part : {frame.position, frame.axis, frame.side}) put_vector3(message, part);
}

void put(MessageWriter& message, const OwnGuide& guide) {
  put(message, guide.root);
  message.put(as_span(guide.points));
}

void put(MessageWriter& message, const hair::GuideFrames& frames) {
  message.put(as_span(frames.arc));
  for (const hair::Matrix3d& turn : frames.turns) message.put(std::span<const double>(turn.data(), 9));
}

hair::RootFrame get_root_frame(MessageReader& message) {
  hair::RootFrame frame;
  for (hair::Vector3d* part : {&frame.position, &frame.axis, &frame.side}) *part = get_vector3(message);
  return frame;
}

OwnGuide get_guide(MessageReader& message) {
  OwnGuide guide;
  guide.root = get_root_frame(message);
  guide.points = as_vector(message.get_doubles());
  if (guide.points.size() < 6 || guide.points.size() % 3 != 0)
    throw MalformedMessage("a guide that is no line of points");
  return guide;
}

hair::GuideFrames get_guide_frames(MessageReader& message, std::size_t points) {
  hair::GuideFrames frames;
  frames.arc = as_vector(message.get_doubles(points));
  frames.turns.resize(points);
  for (hair::Matrix3d& turn : frames.turns) {
    const std::vector<double> numbers = message.get_doubles(9);
    std::copy(numbers.begin(), numbers.end(), turn.data());
  }
  return frames;
}

}  // namespace grader
