#include "hair/rigid_links/rigid_links_body.h"

#include <Eigen/LU>

#include <algorithm>
#include <utility>

#include "hair/strand/turns.h"

namespace hair {

using Eigen::Quaterniond;

namespace {

// A link's orientation and angular velocity from a body's coordinates.
struct Turned {
  Quaterniond axes;
  Vector3d omega;

  Turned(const Vector3d& turn, const Vector3d& rate, const Quaterniond& at_first)
      : axes(turn_by(turn) * at_first), omega(rate_of_turn(turn).inverse() * rate) {}
  Vector3d along() const { return axes * Vector3d::UnitZ(); }
};

double mass_of(const LinkTree& tree) {
  double sum = 0;
  for (const LinkShape& shape : tree.shapes()) sum += shape.mass;
  return sum;
}

}  // namespace

RigidLinksBody::RigidLinksBody(LinkStrand strand, const Vector3d& root_velocity, TreeStep method,
                               bool watched)
    : strand_(std::move(strand)),
      steps_(strand_.tree, strand_.forces),
      method_(method),
      rod_points_(2 * strand_.length.size()),
      arms_(rod_points_.size()),
      after_(rod_points_.size()),
      contacts_(rod_points_.size()) {
  root_.velocity = root_velocity;
  Quaterniond axes = strand_.base.orientation;
  for (int i = 0; i <= links(); ++i) {
    axes = (axes * shape(i).rest).normalized();
    at_rest_.push_back(axes);
  }
  root_.angular_velocity.setZero();
  if (watched) energy_.emplace(strand_, method == &TreeSteps::linearly_implicit_euler);
}

Eigen::VectorXd RigidLinksBody::arc_lengths() const {
  Eigen::VectorXd s = Eigen::VectorXd::Zero(points());
  for (int i = 0; i < links(); ++i) s[i + 1] = s[i] + strand_.length[i];
  return s;
}

void RigidLinksBody::read(particles::Output q, particles::Output rate) const {
  q.head<3>() = strand_.base.position;
  rate.head<3>() = strand_.base.velocity.linear;
  Quaterniond axes = strand_.base.orientation;
  Vector3d omega = strand_.base.velocity.angular;
  for (int i = 1; i <= links(); ++i) {
    axes = axes * shape(i).rest * Quaterniond(strand_.q.segment<4>(4 * i - 4));
    omega += strand_.rates.segment<3>(3 * i - 3);
    const Vector3d turn = turn_of((axes * at_rest_[i].conjugate()).normalized());
    q.segment<3>(3 * i) = turn;
    rate.segment<3>(3 * i) = rate_of_turn(turn) * omega;
  }
}

void RigidLinksBody::write(particles::Input q, particles::Input rate) {
  strand_.base.position = q.head<3>();
  strand_.base.velocity.linear = root_.velocity = rate.head<3>();
  Quaterniond before = strand_.base.orientation;
  Vector3d omega = strand_.base.velocity.angular;
  for (int i = 1; i <= links(); ++i) {
    const Turned link(q.segment<3>(3 * i), rate.segment<3>(3 * i), at_rest_[i]);
    strand_.q.segment<4>(4 * i - 4) =
        ((before * shape(i).rest).conjugate() * link.axes).normalized().coeffs();
    strand_.rates.segment<3>(3 * i - 3) = link.omega - omega;
    before = link.axes;
    omega = link.omega;
  }
  steps_.system().momenta().forget();
  if (energy_) energy_->restart();
}

void RigidLinksBody::set_root(const Root& root) {
  root_ = root;
  told_ = true;
}

std::optional<Stage> RigidLinksBody::step(const BodyStep& step, const particles::Scratch&, Work& work) {
  TreeBase& base = strand_.base;
  const bool turned = told_ && strand_.clamped;  // a hinge ignores its root's turn
  const SpatialMotion goal{turned ? root_.angular_velocity : Vector3d::Zero(), root_.velocity};
  base.acceleration = 1 / step.h * (goal + -1.0 * base.velocity);
  if (energy_) energy_->before_step(goal, steps_.system());
  more_.clear();
  for (const PointForce& one : step.forces)
    if (one.point > 0)
      more_.push_back({one.point, Vector3d(0, 0, strand_.length[one.point - 1] / 2), one.force, one.stiffness,
                       Matrix3d::Zero()});
  if (step.obstacles.empty())
    (steps_.*method_)(base, step.h, more_, strand_.q, strand_.rates);
  else
    step_among(step);
  work.contacts += contacts_.contacts();
  work.penetration = std::max(work.penetration, contacts_.deepest());

  base.position = told_ ? root_.position : Vector3d(base.position + step.h * goal.linear);
  if (turned) base.orientation = root_axes(root_.tangent, root_.normal);
  base.velocity = goal;
  told_ = false;
  ++work.strand_steps;
  work.kept_steps += steps_.system().momenta().in_use();
  steps_.system().momenta().next();
  if (!is_sound()) return Stage::integration;
  if (energy_) watch(step);
  return {};
}

void RigidLinksBody::watch(const BodyStep& step) {
  ContactWork contacts;
  if (contacts_.contacts() > 0) contacts = contacts_.work(after_);
  energy_->after_step(steps_.system(), step.h, contacts_.contacts() > 0 ? &contacts : nullptr);
}

void RigidLinksBody::step_among(const BodyStep& step) {
  const std::size_t others = more_.size();
  find_points();
  contacts_.find(rod_points_, step.obstacles, strand_.forces.gravity, step.h);
  q_before_ = strand_.q;
  rates_before_ = strand_.rates;
  for (int again = 0;; ++again) {
    more_.erase(more_.begin() + static_cast<std::ptrdiff_t>(others), more_.end());
    for (const ContactForce& one : contacts_.forces(rod_points_)) {
      const int link = static_cast<int>(one.point / 2) + 1;
      const double along = one.point % 2 == 0 ? 0 : strand_.length[link - 1] / 2;
      more_.push_back({link, Vector3d(0, 0, along), one.force, one.stiffness, one.damping});
    }
    (steps_.*method_)(strand_.base, step.h, more_, strand_.q, strand_.rates);
    find_velocities_after(step.h);
    if (!contacts_.let_go(after_) || again == kMostContactSteps) return;
    strand_.q = q_before_;
    strand_.rates = rates_before_;
  }
}

void RigidLinksBody::find_points() {
  Vector3d x = strand_.base.position, v = strand_.base.velocity.linear, omega = strand_.base.velocity.angular;
  Quaterniond axes = strand_.base.orientation;
  for (int i = 1; i <= links(); ++i) {
    axes = axes * shape(i).rest * Quaterniond(strand_.q.segment<4>(4 * i - 4));
    omega += strand_.rates.segment<3>(3 * i - 3);
    const double half = strand_.length[i - 1] / 2;
    const Vector3d rod = half * (axes * Vector3d::UnitZ());
    for (int end = 0; end < 2; ++end) {
      x += rod;
      v += omega.cross(rod);
      rod_points_[2 * i - 2 + end] = {shape(i).mass, x, v};
      arms_[2 * i - 2 + end] = end * rod;
    }
  }
}

// The velocities after the step, with the points at their old positions.
void RigidLinksBody::find_velocities_after(double h) {
  const std::vector<LinkPass>& passes = steps_.system().motion().passes;
  for (std::size_t i = 0; i < rod_points_.size(); ++i) {
    const SpatialMotion& a = passes[i / 2 + 1].a;
    after_[i] = rod_points_[i].v + h * (a.linear + a.angular.cross(arms_[i]));
  }
}

Sizes RigidLinksBody::sizes() const {
  Sizes sizes;
  if (energy_) add(energy_->watch(), sizes);
  sizes[Concern::penetration] = contacts_.deepest();
  return sizes;
}

// False if a link turns faster than light.
bool RigidLinksBody::is_sound() const {
  return strand_.q.allFinite() && strand_.rates.allFinite() && strand_.base.position.norm() <= kFarthest &&
         strand_.rates.cwiseAbs().maxCoeff() * strand_.length.maxCoeff() <= kFastest;
}

void RigidLinksBody::centre_line(particles::Input q, particles::Input rate, particles::Output x,
                                 particles::Output v) const {
  x.head<3>() = q.head<3>();
  v.head<3>() = rate.head<3>();
  for (int i = 1; i <= links(); ++i) {
    const Turned link(q.segment<3>(3 * i), rate.segment<3>(3 * i), at_rest_[i]);
    const Vector3d rod = strand_.length[i - 1] * link.along();
    x.segment<3>(3 * i) = x.segment<3>(3 * i - 3) + rod;
    v.segment<3>(3 * i) = v.segment<3>(3 * i - 3) + link.omega.cross(rod);
  }
}

BodyMeasures RigidLinksBody::measure(particles::Input q, particles::Input rate) const {
  BodyMeasures sum;
  Vector3d x = q.head<3>(), v = rate.head<3>();
  Quaterniond before = strand_.base.orientation;
  for (int i = 1; i <= links(); ++i) {
    const Turned link(q.segment<3>(3 * i), rate.segment<3>(3 * i), at_rest_[i]);
    const Vector3d half = strand_.length[i - 1] / 2 * link.along();
    const Vector3d centre = x + half, velocity = v + link.omega.cross(half);
    const double mass = shape(i).mass;
    const Vector3d own = link.axes.conjugate() * link.omega;
    const Vector3d spin = link.axes * Vector3d(shape(i).moments.cwiseProduct(own));
    const Vector3d bent = turn_of((before * shape(i).rest).conjugate() * link.axes);
    sum.kinetic += (mass * velocity.squaredNorm() + link.omega.dot(spin)) / 2;
    sum.potential += strand_.forces.springs[i].energy(bent) - mass * strand_.forces.gravity.dot(centre);
    sum.momentum += mass * velocity;
    sum.angular_momentum += mass * centre.cross(velocity) + spin;
    x = centre + half;
    v = velocity + link.omega.cross(half);
    before = link.axes;
  }
  sum.tip = x;
  return sum;
}

LinkEnergy::LinkEnergy(const LinkStrand& strand, bool implicit)
    : strand_(strand),
      implicit_(implicit),
      rates_before_(strand.rates),
      mass_(mass_of(strand.tree)),
      watch_(mass_, strand.length.sum(), strand.forces.gravity.norm(), strand.forces.drag) {}

// Reads the energies of the present strand, relative to its base.
void LinkEnergy::read(TreeSystem& system, bool found) {
  TreeMotion& motion = system.motion();
  energies_ = {};
  momentum_.setZero();
  if (!found) {
    motion.place(strand_.base, strand_.q);
    outward_velocities(motion.links, strand_.rates, motion.passes);
  }
  for (std::size_t i = 1; i < motion.links.size(); ++i) {
    const double mass = strand_.tree.shapes()[i].mass;
    const SpatialMotion& v = found ? system.momenta().velocities()[i] : motion.passes[i].v;
    const Vector3d velocity = v.linear - strand_.base.velocity.linear;
    energies_.kinetic +=
        (mass * velocity.squaredNorm() + v.angular.dot(motion.links[i].tensor * v.angular)) / 2;
    momentum_ += mass * velocity;
  }
  motion.place(strand_.base, strand_.q);
  for (std::size_t i = 1; i < motion.links.size(); ++i) {
    const LinkFrame& frame = motion.frames()[i];
    energies_.weight -=
        strand_.tree.shapes()[i].mass * strand_.forces.gravity.dot(frame.position - strand_.base.position);
    energies_.elastic += strand_.forces.springs[i].energy(frame.turn);
  }
}

void LinkEnergy::before_step(const SpatialMotion& base, TreeSystem& system) {
  rates_before_ = strand_.rates;
  base_before_ = strand_.base.velocity;
  base_ = base;
  root_velocity_ = mean(base_before_.linear, base.linear);
  if (!watch_.begun()) {
    read(system, false);
    watch_.begin(energies_);
  }
  momentum_before_ = momentum_;
}

void LinkEnergy::after_step(TreeSystem& system, double h, const ContactWork* contacts) {
  const LinkPass& root = system.motion().passes.front();
  const Vector3d torque = (root.inertia * root.a + root.bias).torque;
  const Vector3d changes = base_.linear - base_before_.linear;
  double work = h * torque.dot(mean(base_before_.angular, base_.angular));
  if (strand_.forces.drag > 0) work += drag_work(system, h);
  work += damping_work(system.motion(), h);
  if (contacts) work += contacts->seen_from(root_velocity_);
  read(system, implicit_);
  const Vector3d momentum_after = implicit_ ? Vector3d(momentum_before_ - mass_ * changes) : momentum_;
  work -= changes.dot(momentum_before_ + momentum_after) / 2;
  watch_.after_step(energies_, work, contacts != nullptr, h);
}

double LinkEnergy::drag_work(const TreeSystem& system, double h) const {
  const TreeMotion& motion = system.motion();
  double power = 0;
  for (std::size_t i = 1; i < motion.passes.size(); ++i) {
    const SpatialMotion &before = motion.passes[i].v, &pushed = motion.passes[i].a;
    const SpatialMotion after = implicit_ ? system.momenta().velocities()[i] : before + h * pushed;
    const SpatialMotion& feels = implicit_ ? after : before;
    const Vector3d e = motion.frames()[i].axes * strand_.forces.rods[i];
    const double squared = e.squaredNorm(), c = strand_.forces.drag * std::sqrt(squared);
    const Vector3d turning = squared * feels.angular - e.dot(feels.angular) * e;
    power -=
        c * (feels.linear - strand_.forces.wind).dot(mean(before.linear, after.linear) - root_velocity_) +
        c / 12 * turning.dot(mean(before.angular, after.angular));
  }
  return h * power;
}

double LinkEnergy::damping_work(const TreeMotion& motion, double h) const {
  double power = 0;
  for (std::size_t i = 1; i < motion.passes.size(); ++i) {
    const Matrix3d& damping = strand_.forces.springs[i].damping;
    if (damping.isZero(0)) continue;
    const Quaterniond back = motion.frames()[i].joint_axes.conjugate();
    const Eigen::Index first = motion.links[i].first;
    const Vector3d rate =
        back * mean(Vector3d(rates_before_.segment<3>(first)), Vector3d(strand_.rates.segment<3>(first)));
    power -= rate.dot(damping * rate);
  }
  return h * power;
}

// The velocity for the work of a step's forces.
Vector3d LinkEnergy::mean(const Vector3d& before, const Vector3d& after) const {
  return implicit_ ? after : Vector3d((before + after) / 2);
}

}  // namespace hair
