#include "hair/truth/strand_ode.h"

#include <algorithm>

namespace hair {

namespace {

bool rests_curved(const StrandStart& start) {
  return start.strand.bend_rigidity > 0 && start.rest_curvature.size() > 0;
}

}  // namespace

Description exact_description(const Problem& problem) {
  Description hair = problem.scene.hair;
  hair.geometric_term = GeometricTerm::full;
  hair.bend_product = Products::exact;
  return hair;
}

Scales strand_scales(const Problem& problem) {
  const StrandStart& start = problem.scene.hair.strands.at(0);
  const double length = start.strand.rest_length.sum();
  double fastest = length / problem.duration;
  for (int i = 0; i < start.strand.count(); ++i)
    fastest = std::max(fastest, start.state.v.segment<3>(3 * i).norm());
  return {length, fastest};
}

StrandOde::StrandOde(const Problem& problem)
    : scene_(problem.scene),
      simulation_(exact_description(problem)),
      root_(scene_),
      n_(scene_.hair.strands[0].strand.count()),
      apart_(rests_curved(scene_.hair.strands[0]) ? n_ : 2 * kReach + 1),
      scales_(strand_scales(problem)),
      state_(scene_.hair.strands[0].state),
      force_(3 * n_),
      change_(3 * n_),
      by_x_(3 * n_),
      by_v_(3 * n_) {}

Eigen::VectorXd StrandOde::start() const {
  const particles::State& state = scene_.hair.strands[0].state;
  Eigen::VectorXd y(size());
  for (int i = 1; i < n_; ++i)
    y.segment<6>(6 * i - 6) << state.x.segment<3>(3 * i), state.v.segment<3>(3 * i);
  return y;
}

Eigen::VectorXd StrandOde::scales() const {
  Eigen::VectorXd scales(size());
  for (int i = 0; i < size(); i += 6) {
    scales.segment<3>(i).setConstant(scales_.position);
    scales.segment<3>(i + 3).setConstant(scales_.velocity);
  }
  return scales;
}

void StrandOde::unpack(double t, particles::Input y) {
  const RootMotion root = root_.at(t);
  state_.x.head<3>() = root.position;
  state_.v.head<3>() = root.velocity;
  for (int i = 1; i < n_; ++i) {
    state_.x.segment<3>(3 * i) = y.segment<3>(6 * i - 6);
    state_.v.segment<3>(3 * i) = y.segment<3>(6 * i - 3);
  }
  if (root_.turns()) simulation_.set_root_frame(0, root.tangent, root.normal);
}

void StrandOde::rates(double t, particles::Input y, particles::Output dy) {
  unpack(t, y);
  force_.setZero();
  simulation_.force(0).add_force(state_.x, state_.v, force_);
  const Eigen::VectorXd& mass = simulation_.particles(0).mass;
  for (int i = 1; i < n_; ++i) {
    dy.segment<3>(6 * i - 6) = y.segment<3>(6 * i - 3);
    dy.segment<3>(6 * i - 3) = force_.segment<3>(3 * i) / mass[i];
  }
}

// Row 6i + 3 + a has df/dx of particles i - kReach to i + kReach: columns 6 (i +- kReach) + b, with a and b
// from 0 to 2.
int StrandOde::above() const {
  return std::min(6 * kReach - 1, size() - 1);
}
int StrandOde::below() const {
  return std::min(6 * kReach + 5, size() - 1);
}

// Particles 2 kReach + 1 apart have no common force: one product serves all of them, for each axis. A. R.
// Curtis, M. J. D. Powell and J. K. Reid, "On the Estimation of Sparse Jacobian Matrices", J. Inst. Maths
// Applics 13 (1974).
bool StrandOde::jacobian(double t, particles::Input y, BandMatrix& df) {
  unpack(t, y);
  const particles::Force& force = simulation_.force(0);
  const Eigen::VectorXd& mass = simulation_.particles(0).mass;
  for (int k = 0; k < size(); k += 6)
    for (int axis = 0; axis < 3; ++axis) df(k + axis, k + 3 + axis) = 1;
  for (int first = 1; first <= std::min(apart_, n_ - 1); ++first) {
    for (int axis = 0; axis < 3; ++axis) {
      change_.setZero();
      for (int i = first; i < n_; i += apart_) change_[3 * i + axis] = 1;
      by_x_.setZero();
      by_v_.setZero();
      force.add_dfdx(state_.x, state_.v, change_, by_x_);
      force.add_dfdv(state_.x, state_.v, change_, by_v_);
      for (int j = first; j < n_; j += apart_) {
        for (int i = std::max(1, j - kReach); i <= std::min(n_ - 1, j + kReach); ++i) {
          for (int row = 0; row < 3; ++row) {
            const int k = 6 * i - 3 + row, l = 6 * j - 6 + axis;
            df(k, l) = by_x_[3 * i + row] / mass[i];
            if (i == j) df(k, l + 3) = by_v_[3 * i + row] / mass[i];
          }
        }
      }
    }
  }
  return true;
}

particles::State StrandOde::state(double t, particles::Input y) {
  unpack(t, y);
  return state_;
}

namespace {

RootMotion start_of(const StrandStart& start) {
  return {start.state.x.head<3>(), start.state.v.head<3>(), Vector3d::Zero(), start.strand.root_tangent,
          start.root_normal};
}

}  // namespace

StrandRoot::StrandRoot(const Scene& scene) : start_(start_of(scene.hair.strands.at(0))) {
  // The last motion counts, as in a simulation.
  for (const Rider& rider : scene.riders)
    if (!rider.strands.empty()) motion_ = &rider.motion;
  if (motion_) turns_ = scene.hair.strands[0].strand.clamped && hair::turns(*motion_);
  start_span(0);
}

std::vector<double> StrandRoot::breaks() const {
  std::vector<double> times;
  if (motion_)
    for (const Key& key : motion_->keys) times.push_back(key.time);
  return times;
}

void StrandRoot::start_span(double time) {
  if (!motion_) return;
  next_key_ = 0;
  while (next_key_ < motion_->keys.size() && motion_->keys[next_key_].time <= time) ++next_key_;
}

RootMotion StrandRoot::at(double time) const {
  RootMotion root = start_;
  if (!motion_) {
    root.position += time * root.velocity;
    return root;
  }
  const Way way = way_at(*motion_, time);
  root.position = way(start_.position);
  root.velocity.setZero();
  if (turns_) {
    root.tangent = (way.rotation * root.tangent).normalized();
    root.normal = (way.rotation * root.normal).normalized();
  }
  if (next_key_ == 0 || next_key_ == motion_->keys.size()) return root;

  // Between two keys Motion::at covers the part w = s^2 (3 - 2s) of the way, and turns by w times an angle
  // about an axis: dp/dw = turn x (p - position) + (to's position - from's position), and so on.
  const Key &from = motion_->keys[next_key_ - 1], &to = motion_->keys[next_key_];
  const double length = to.time - from.time, s = (time - from.time) / length;
  const double dw = 6 * s * (1 - s) / length, ddw = (6 - 12 * s) / (length * length);
  const Eigen::AngleAxisd turn(to.pose.rotation * from.pose.rotation.conjugate());
  const Vector3d spin = turn.angle() * turn.axis();
  const Vector3d arm = root.position - way.to;
  const Vector3d along = spin.cross(arm) + to.pose.position - from.pose.position;
  root.velocity = dw * along;
  root.acceleration = ddw * along + dw * dw * spin.cross(spin.cross(arm));
  return root;
}

}  // namespace hair
