#include "hair/truth/rigid_strand_ode.h"

#include <algorithm>
#include <cmath>

#include "hair/truth/strand_ode.h"

namespace hair {

namespace {

Description without_stretching(const Problem& problem) {
  Description hair = exact_description(problem);
  hair.strands.at(0).strand.stretch_rigidity = 0;
  return hair;
}

}  // namespace

double times_the_ea_of_hair(const Strand& strand) {
  const Material hair;
  const double line_density = strand.mass.sum() / strand.rest_length.sum();
  return strand.stretch_rigidity / (hair.young_modulus / hair.density * line_density);
}

bool starts_rigid(const Problem& problem) {
  constexpr double kSame = 1e-9;
  const StrandStart& start = problem.scene.hair.strands.at(0);
  const double speed = strand_scales(problem).velocity;
  for (int i = 0; i < start.strand.segments(); ++i) {
    const Vector3d e = start.state.x.segment<3>(3 * i + 3) - start.state.x.segment<3>(3 * i);
    const Vector3d de = start.state.v.segment<3>(3 * i + 3) - start.state.v.segment<3>(3 * i);
    const double length = start.strand.rest_length[i];
    if (std::abs(e.norm() - length) > kSame * length) return false;
    if (std::abs(e.dot(de)) > kSame * speed * length) return false;
  }
  return true;
}

RigidStrandOde::RigidStrandOde(const Problem& problem)
    : scene_(problem.scene),
      simulation_(without_stretching(problem)),
      root_(scene_),
      segments_(scene_.hair.strands[0].strand.segments()),
      velocity_scale_(strand_scales(problem).velocity / strand_scales(problem).position),
      u_(3, segments_),
      w_(3, segments_),
      a_(3, segments_ + 1),
      tension_(segments_),
      diagonal_(segments_),
      state_(scene_.hair.strands[0].state),
      force_(3 * (segments_ + 1)) {}

Eigen::VectorXd RigidStrandOde::start() const {
  const StrandStart& start = scene_.hair.strands[0];
  Eigen::VectorXd y(size());
  for (int i = 0; i < segments_; ++i) {
    const Vector3d e = start.state.x.segment<3>(3 * i + 3) - start.state.x.segment<3>(3 * i);
    const Vector3d de = start.state.v.segment<3>(3 * i + 3) - start.state.v.segment<3>(3 * i);
    y.segment<6>(6 * i) << e.normalized(), de / start.strand.rest_length[i];
  }
  return y;
}

Eigen::VectorXd RigidStrandOde::scales() const {
  Eigen::VectorXd scales(size());
  for (int i = 0; i < size(); i += 6) {
    scales.segment<3>(i).setConstant(1);
    scales.segment<3>(i + 3).setConstant(velocity_scale_);
  }
  return scales;
}

void RigidStrandOde::unpack(double t, particles::Input y) {
  const Eigen::VectorXd& length = scene_.hair.strands[0].strand.rest_length;
  at_root_ = root_.at(t);
  state_.x.head<3>() = at_root_.position;
  state_.v.head<3>() = at_root_.velocity;
  for (int i = 0; i < segments_; ++i) {
    u_.col(i) = y.segment<3>(6 * i).normalized();
    w_.col(i) = y.segment<3>(6 * i + 3);
    w_.col(i) -= w_.col(i).dot(u_.col(i)) * u_.col(i);
    state_.x.segment<3>(3 * i + 3) = state_.x.segment<3>(3 * i) + length[i] * u_.col(i);
    state_.v.segment<3>(3 * i + 3) = state_.v.segment<3>(3 * i) + length[i] * w_.col(i);
  }
  if (root_.turns()) simulation_.set_root_frame(0, at_root_.tangent, at_root_.normal);
}

// Turns a_, the particles' accelerations without tensions, into those with them.
void RigidStrandOde::find_tensions() {
  const Strand& strand = scene_.hair.strands[0].strand;
  const auto inverse_mass = [&](int i) { return i == 0 ? 0 : 1 / strand.mass[i]; };
  // Row i of the matrix: -link(i), inverse_mass(i) + inverse_mass(i + 1), -link(i + 1).
  const auto link = [&](int i) { return inverse_mass(i) * u_.col(i - 1).dot(u_.col(i)); };
  for (int i = 0; i < segments_; ++i) {
    tension_[i] = u_.col(i).dot(a_.col(i + 1) - a_.col(i)) + strand.rest_length[i] * w_.col(i).squaredNorm();
    diagonal_[i] = inverse_mass(i) + inverse_mass(i + 1);
    if (i == 0) continue;
    const double share = link(i) / diagonal_[i - 1];
    diagonal_[i] -= share * link(i);
    tension_[i] += share * tension_[i - 1];
  }
  for (int i = segments_ - 1; i >= 0; --i) {
    if (i + 1 < segments_) tension_[i] += link(i + 1) * tension_[i + 1];
    tension_[i] /= diagonal_[i];
  }
  for (int i = 0; i < segments_; ++i) {
    a_.col(i) += inverse_mass(i) * tension_[i] * u_.col(i);
    a_.col(i + 1) -= inverse_mass(i + 1) * tension_[i] * u_.col(i);
  }
}

void RigidStrandOde::rates(double t, particles::Input y, particles::Output dy) {
  unpack(t, y);
  force_.setZero();
  simulation_.force(0).add_force(state_.x, state_.v, force_);
  const Strand& strand = scene_.hair.strands[0].strand;
  a_.col(0) = at_root_.acceleration;
  for (int i = 1; i <= segments_; ++i) a_.col(i) = force_.segment<3>(3 * i) / strand.mass[i];
  find_tensions();
  const double stretch = tension_.cwiseAbs().dot(strand.rest_length) / strand.stretch_rigidity;
  stretch_ = std::max(stretch_, stretch);
  for (int i = 0; i < segments_; ++i)
    dy.segment<6>(6 * i) << w_.col(i), (a_.col(i + 1) - a_.col(i)) / strand.rest_length[i];
}

particles::State RigidStrandOde::state(double t, particles::Input y) {
  unpack(t, y);
  return state_;
}

}  // namespace hair
