#include "hair/rigid_links/tree_system.h"

#include <algorithm>
#include <utility>

namespace hair {

namespace {

constexpr int kMostLimits = 10;    // attempts in which limits may end, and as many in which they only begin
constexpr double kSettled = 0.01;  // times a limit: attempts that differ by less are the same

}  // namespace

TreeSystem::TreeSystem(const LinkTree& tree, TreeForces forces)
    : motion_(tree), forces_(std::move(forces)), momenta_(tree, forces_), Q_(tree.rates()) {
  const auto has_limit = [](const JointSpring& spring) { return spring.limit_stiffness > 0; };
  if (std::any_of(forces_.springs.begin(), forces_.springs.end(), has_limit)) limits_.resize(tree.links());
}

void TreeSystem::accelerations(const TreeBase& base, Input q, Input rates, double h,
                               std::span<const LinkForce> more, Output result) {
  momenta_.begin();
  settle(base, q, rates, h, more, result);
  if (h == 0 || !forces_.bend_rigidity || !momenta_.ask_for(motion_, rates, result, h)) return;
  settle(base, q, rates, h, more, result);
  momenta_.ask_for(motion_, rates, result, h);
}

void TreeSystem::settle(const TreeBase& base, Input q, Input rates, double h, std::span<const LinkForce> more,
                        Output result) {
  if (limits_.empty()) {
    attempt(base, q, rates, h, more, result);
    return;
  }
  std::fill(limits_.begin(), limits_.end(), Limit{});
  result.setZero();
  motion_.place(base, q);
  change_limits(q, rates, result, h, true);
  for (int again = 1;; ++again) {
    attempt(base, q, rates, h, more, result);
    const bool most = again == 2 * kMostLimits;
    if (h == 0 || most || !change_limits(q, rates, result, h, again < kMostLimits)) return;
  }
}

bool TreeSystem::change_limits(Input q, Input rates, Input accelerations, double h, bool may_end) {
  bool any = false;
  for (std::size_t i = 1; i < motion_.links.size(); ++i) {
    const JointSpring& spring = forces_.springs[i];
    if (spring.limit_stiffness == 0) continue;
    Limit& limit = limits_[i];
    const Link& link = motion_.links[i];
    const int first = tree().coordinate(static_cast<int>(i));
    Vector3d end(0, 0, 0);
    if (link.joint == JointType::spherical) {
      const Vector3d& theta = motion_.frames()[i].turn;
      const Vector3d turn = h * (rates.segment<3>(link.first) + h * accelerations.segment<3>(link.first));
      end = theta + rate_of_turn(theta) * (motion_.frames()[i].joint_axes.conjugate() * turn);
    } else {
      end[0] = q[first] + h * (rates[link.first] + h * accelerations[link.first]);
    }
    const bool was = limit.acts;
    const Vector3d was_at = (limit.bound + limit.beyond) * limit.along;
    if (was) {
      limit.acts = !may_end || limit.along.dot(end) >= limit.bound;
      if (limit.acts && link.joint == JointType::spherical) limit.along = end.normalized();
    } else {
      const bool below = link.joint != JointType::spherical && end[0] < spring.lower;
      limit.acts = below || (link.joint == JointType::spherical ? end.norm() : end[0]) > spring.upper;
      if (below)
        limit = {true, -spring.lower, Vector3d(-1, 0, 0)};
      else if (limit.acts)
        limit = {true, spring.upper, end.normalized()};
    }
    limit.beyond = end.norm() - limit.bound;
    const bool moves =
        limit.acts && link.joint == JointType::spherical && (end - was_at).norm() > kSettled * limit.bound;
    any |= was != limit.acts || moves;
  }
  return any;
}

// `to_rates`: from the direction of the joint's coordinate to its rates.
void TreeSystem::add_limit(int joint, Input rates, double h, const Vector3d& place,
                           const Matrix3d& to_rates) {
  const Limit& limit = limits_[joint];
  if (!limit.acts) return;
  Link& link = motion_.links[joint];
  const double k = forces_.springs[joint].limit_stiffness;
  if (link.joint == JointType::spherical) {
    // N is that after the step or at its start: the larger one holds.
    const double beyond = std::max({0.0, limit.beyond, limit.along.dot(place) - limit.bound});
    const double across = k * beyond / (limit.bound + beyond);
    const Matrix3d K = across * Matrix3d::Identity() + (k - across) * limit.along * limit.along.transpose();
    const Vector3d end = place + h * (to_rates.transpose() * rates.segment<3>(link.first));
    Q_.segment<3>(link.first) -= to_rates * (K * end - k * limit.bound * limit.along);
    link.stiffening += h * h * to_rates * K * to_rates.transpose();
  } else {
    Q_[link.first] -= k * (place[0] + h * rates[link.first] - limit.along[0] * limit.bound);
    link.stiffening(0, 0) += h * h * k;
  }
}

void TreeSystem::attempt(const TreeBase& base, Input q, Input rates, double h,
                         std::span<const LinkForce> more, Output result) {
  motion_.place(base, q);
  for (std::size_t i = 1; i < motion_.links.size(); ++i)
    motion_.links[i].external.force = tree().shapes()[i].mass * forces_.gravity;
  Q_.setZero();
  if (!forces_.springs.empty()) add_springs(q, rates, h);
  outward_velocities(motion_.links, rates, motion_.passes);
  if (momenta_.in_use()) momenta_.add_to(motion_, h);
  if (forces_.drag > 0) add_drag(h);
  for (const LinkForce& one : more) add_force(one, h);
  inward_inertias(motion_.links, Q_, motion_.passes);
  outward_accelerations(motion_.links, Q_, motion_.passes, result);
}

void TreeSystem::add_springs(Input q, Input rates, double h) {
  for (std::size_t i = 1; i < motion_.links.size(); ++i) {
    Link& link = motion_.links[i];
    const JointSpring& spring = forces_.springs[i];
    const Matrix3d &K = spring.stiffness, &C = spring.damping;
    const int first = tree().coordinate(static_cast<int>(i));
    if (link.joint == JointType::spherical) {
      const Matrix3d axes = motion_.frames()[i].joint_axes.toRotationMatrix();
      const Vector3d& theta = motion_.frames()[i].turn;
      const Matrix3d A = rate_of_turn(theta), AK = A.transpose() * K, stiffness = AK * A;
      const Vector3d w = axes.transpose() * rates.segment<3>(link.first);
      Q_.segment<3>(link.first) = -axes * (AK * theta + C * w + h * (stiffness * w));
      if (h > 0) link.stiffening = axes * (h * h * stiffness + h * C) * axes.transpose();
      if (!limits_.empty()) add_limit(static_cast<int>(i), rates, h, theta, axes * A.transpose());
    } else {
      const double rate = rates[link.first];
      Q_[link.first] = -K(0, 0) * (q[first] + h * rate) - C(0, 0) * rate;
      link.stiffening(0, 0) = h * h * K(0, 0) + h * C(0, 0);
      if (!limits_.empty())
        add_limit(static_cast<int>(i), rates, h, Vector3d(q[first], 0, 0), Matrix3d::Identity());
    }
  }
}

// A rod e of the length l in still air feels -drag l v, and -drag / 12 l (l^2 - e e^T) omega.
void TreeSystem::add_drag(double h) {
  for (std::size_t i = 1; i < motion_.links.size(); ++i) {
    const Vector3d e = motion_.frames()[i].axes * forces_.rods[i];
    const double squared = e.squaredNorm(), c = forces_.drag * std::sqrt(squared);
    const Matrix3d turning = c / 12 * (squared * Matrix3d::Identity() - e * e.transpose());
    LinkPass& pass = motion_.passes[i];
    pass.bias.force += c * (pass.v.linear - forces_.wind);
    pass.bias.torque += turning * pass.v.angular;
    motion_.links[i].inertia.M.diagonal().array() += h * c;
    motion_.links[i].inertia.J += h * turning;
  }
}

void TreeSystem::add_force(const LinkForce& one, double h) {
  LinkPass& pass = motion_.passes[one.link];
  const Vector3d arm = motion_.frames()[one.link].axes * one.arm;
  const Vector3d v = pass.v.linear + pass.v.angular.cross(arm);
  const Vector3d f = one.force - h * (one.stiffness * v);
  pass.bias.force -= f;
  pass.bias.torque -= arm.cross(f);
  if (h > 0) {
    const Matrix3d resists = h * h * one.stiffness + h * one.damping;
    motion_.links[one.link].inertia += to_parent({resists, Matrix3d::Zero(), Matrix3d::Zero()}, arm);
  }
}

double TreeSystem::kinetic_energy() const {
  double sum = 0;
  for (std::size_t i = 1; i < motion_.links.size(); ++i) {
    const SpatialMotion& v = motion_.passes[i].v;
    sum +=
        tree().shapes()[i].mass * v.linear.squaredNorm() + v.angular.dot(motion_.links[i].tensor * v.angular);
  }
  return sum / 2;
}

double TreeSystem::potential_energy(Input q) const {
  double sum = 0;
  for (std::size_t i = 1; i < motion_.links.size(); ++i) {
    sum -= tree().shapes()[i].mass * forces_.gravity.dot(motion_.frames()[i].position);
    if (forces_.springs.empty()) continue;
    const JointSpring& spring = forces_.springs[i];
    const int first = tree().coordinate(static_cast<int>(i));
    sum += motion_.links[i].joint == JointType::spherical
               ? spring.energy(turn_of(Eigen::Quaterniond(q.segment<4>(first))))
               : spring.energy(q[first]);
  }
  return sum;
}

}  // namespace hair
