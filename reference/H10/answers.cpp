// STAFF ONLY. Asks a student's functions of H10.
#include "reference/H10/answers.h"

#include <cmath>

#include "grader/judge/case_asker.h"
#include "reference/H10/calls.h"

namespace grader::h10 {
namespace {

std::string points_of(const VectorXd& guide) {
  return std::to_string(guide.size() / 3) + " points";
}

}  // namespace

Weights ask_weights(Trial& trial, const Corners& corners, const Vector3d& root) {
  return ask_student_for<Calls, hair::root_weights>(trial, corners, root);
}

VectorXd ask_interpolated(Trial& trial, const std::array<OwnGuide, 3>& guides, const Weights& weights,
                          const RootFrame& root) {
  trial.describe("guides of " + points_of(guides[0].points) + ", weights " + std::to_string(weights[0]) +
                 ", " + std::to_string(weights[1]) + ", " + std::to_string(weights[2]));
  const std::array<hair::GuideHair, 3> seen{guides[0].view(), guides[1].view(), guides[2].view()};
  VectorXd child = unset(guides[0].points.size());
  ask_student_for<Calls, hair::interpolate>(trial, seen, weights, root, child);
  return child;
}

GuideFrames ask_frames(Trial& trial, const VectorXd& guide) {
  trial.describe("a guide of " + points_of(guide));
  const Eigen::Index points = guide.size() / 3;
  GuideFrames frames{unset(points), std::vector<hair::Matrix3d>(static_cast<std::size_t>(points),
                                                                hair::Matrix3d::Constant(std::nan("")))};
  ask_student_for<Calls, hair::carry_along>(trial, guide, frames);
  return frames;
}

VectorXd ask_extrapolated(Trial& trial, const VectorXd& guide, const GuideFrames& frames,
                          const Vector3d& root, double spread) {
  trial.describe("a guide of " + points_of(guide) + ", spread " + std::to_string(spread));
  VectorXd child = unset(guide.size());
  ask_student_for<Calls, hair::extrapolate>(trial, guide, frames, root, spread, child);
  return child;
}

VectorXd ask_blended(Trial& trial, const VectorXd& arc, VectorXd at_root, VectorXd at_tip, Place place) {
  trial.describe(std::to_string(arc.size()) + " points, into " +
                 (place == Place::own       ? "memory of its own"
                  : place == Place::at_root ? "at_root"
                                            : "at_tip"));
  VectorXd own = unset(at_root.size());
  VectorXd& child = place == Place::own ? own : place == Place::at_root ? at_root : at_tip;
  ask_student_for<Calls, hair::blend>(trial, arc, at_root, at_tip, child);
  return child;
}

}  // namespace grader::h10
