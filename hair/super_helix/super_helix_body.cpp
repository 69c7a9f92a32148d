#include "hair/super_helix/super_helix_body.h"

#include <Eigen/LU>

#include <utility>

#include "hair/strand/blow_up.h"
#include "hair/strand/turns.h"
#include "hair/super_helix/helix_forces.h"

namespace hair {

using Eigen::Quaterniond;

SuperHelixBody::SuperHelixBody(HelixStart start, const HelixSurroundings& surroundings,
                               const Vector3d& root_velocity, bool watched)
    : axes_at_start_(start.root.frame.axes),
      root_(start.root),
      q_(std::move(start.q)),
      rates_(Eigen::VectorXd::Zero(q_.size())),
      change_(q_.size()),
      places_(std::move(start.places)),
      motion_(std::move(start.strand), places_),
      surroundings_(surroundings),
      damped_(motion_.strand()),
      contact_points_(places_.size() - 1),
      without_contacts_(contact_points_.size()),
      after_(contact_points_.size()),
      contacts_(contact_points_.size()) {
  goal_.velocity = root_velocity;
  goal_.angular_velocity.setZero();
  if (watched) energy_.emplace(motion_.strand(), surroundings);
}

Eigen::VectorXd SuperHelixBody::arc_lengths() const {
  return Eigen::Map<const Eigen::VectorXd>(places_.data(), points());
}

void SuperHelixBody::read(particles::Output q, particles::Output rate) const {
  const Vector3d turn = turn_of(Quaterniond(Matrix3d(root_.frame.axes * axes_at_start_.transpose())));
  q << root_.frame.position, turn, q_;
  rate << root_.velocity, rate_of_turn(turn) * root_.spin, rates_;
}

HelixRoot SuperHelixBody::root_at(particles::Input q, particles::Input rate) const {
  const Vector3d turn = q.segment<3>(3);
  HelixRoot root;
  root.frame = {q.head<3>(), turn_by(turn).toRotationMatrix() * axes_at_start_};
  root.velocity = rate.head<3>();
  root.spin = rate_of_turn(turn).inverse() * rate.segment<3>(3);
  return root;
}

void SuperHelixBody::write(particles::Input q, particles::Input rate) {
  root_ = root_at(q, rate);
  goal_.velocity = root_.velocity;
  q_ = q.tail(q_.size());
  rates_ = rate.tail(q_.size());
  has_momentum_ = placed_ = false;
  if (energy_) energy_->restart();
}

void SuperHelixBody::set_root(const Root& root) {
  goal_ = root;
  told_ = true;
}

std::optional<Stage> SuperHelixBody::step(const BodyStep& step, const particles::Scratch& scratch,
                                          Work& work) {
  const double h = step.h;
  const Vector3d spin = told_ ? goal_.angular_velocity : Vector3d::Zero();
  if (!placed_) motion_.place(root_.frame, q_);
  placed_ = false;
  if (energy_) {
    if (!energy_->watch().begun()) motion_.move(root_, rates_);
    energy_->before_step(motion_, q_, root_.velocity, goal_.velocity);
  }
  if (has_momentum_) {
    root_.velocity = goal_.velocity;
    root_.spin = spin;
    motion_.move(root_, rates_);
    momentum_.add_to(motion_, h);
  } else {
    start_moving(spin, h);
  }
  add_forces(step);
  const HelixStrand& strand = strand_of_step(h);
  if (step.obstacles.empty())
    helix_step(strand, motion_.elements, motion_.points, q_, rates_, h, scratch, change_);
  else
    step_among(step, strand, scratch);
  work.contacts += contacts_.contacts();
  work.penetration = std::max(work.penetration, contacts_.deepest());
  rates_ += change_;
  momentum_.keep(motion_, root_, rates_);
  has_momentum_ = true;
  if (energy_) weigh(h);
  q_ += h * rates_;
  drop_traces(rates_);
  drop_traces(q_);

  MaterialFrame& frame = root_.frame;
  frame.position = told_ ? goal_.position : Vector3d(frame.position + h * goal_.velocity);
  if (told_) frame.axes = root_axes(goal_.tangent, goal_.normal).toRotationMatrix();
  told_ = false;
  ++work.strand_steps;
  if (!is_sound()) return Stage::integration;
  if (energy_) {
    motion_.place(root_.frame, q_);
    placed_ = true;
    energy_->after_step(motion_, q_, h);
  }
  return {};
}

// Called while the strand is still placed as in the step.
void SuperHelixBody::weigh(double h) {
  ContactWork contacts;
  if (contacts_.contacts() > 0) contacts = contacts_.work(after_);
  move_by_change();
  energy_->found(motion_, momentum_.velocities(), h, root_.spin, rates_,
                 contacts_.contacts() > 0 ? &contacts : nullptr);
}

// A step without momenta of a previous step uses accelerations, also the root's.
void SuperHelixBody::start_moving(const Vector3d& spin, double h) {
  root_.acceleration = (goal_.velocity - root_.velocity) / h;
  root_.spin_acceleration = (spin - root_.spin) / h;
  motion_.move(root_, rates_);
  motion_.accelerate(root_, rates_);
  add_motion(motion_);
  for (std::size_t j = 0; j < motion_.points.size(); ++j)
    motion_.velocities[j] += h * motion_.accelerations[j];
  root_.velocity = goal_.velocity;
  root_.spin = spin;
  root_.acceleration.setZero();
  root_.spin_acceleration.setZero();
}

void SuperHelixBody::add_forces(const BodyStep& step) {
  if (surroundings_.gravity != Vector3d::Zero()) add_weight(surroundings_.gravity, motion_);
  if (surroundings_.drag > 0) add_drag(surroundings_.drag, surroundings_.wind, step.h, motion_);
  for (const PointForce& one : step.forces) add_point_force(one, step.h);
}

// f - S h v, with v at the end of the step: the part of `change_` acts as a resistance.
void SuperHelixBody::add_point_force(const PointForce& one, double h) {
  const std::size_t j = motion_.placed[one.point];
  motion_.points[j].force += one.force - h * (one.stiffness * motion_.velocities[j]);
  motion_.points[j].inertia += h * h * one.stiffness;
}

// With the damping t K the step is (M + (h^2 + h t) K) change = h (Q - K (q + h q' - q^n) - t K q'). This is
// the step of a strand that is 1 + t/h times as stiff, and whose natural shape is nearer to q by the same
// factor.
const HelixStrand& SuperHelixBody::strand_of_step(double h) {
  const HelixStrand& strand = motion_.strand();
  if (surroundings_.relaxation_time == 0) return strand;
  const double factor = 1 + surroundings_.relaxation_time / h;
  damped_.bend_rigidity = factor * strand.bend_rigidity;
  damped_.twist_rigidity = factor * strand.twist_rigidity;
  damped_.natural = q_ - (q_ - strand.natural) / factor;
  return damped_;
}

void SuperHelixBody::step_among(const BodyStep& step, const HelixStrand& strand, particles::Scratch scratch) {
  const double h = step.h;
  find_points();
  contacts_.find(contact_points_, step.obstacles, surroundings_.gravity, h);
  for (int again = 0;; ++again) {
    for (std::size_t i = 0; i < contact_points_.size(); ++i) {
      HelixPoint& point = motion_.points[motion_.placed[i + 1]];
      point.force = without_contacts_[i].force;
      point.inertia = without_contacts_[i].resists;
    }
    for (const ContactForce& one : contacts_.forces(contact_points_)) {
      HelixPoint& point = motion_.points[motion_.placed[one.point + 1]];
      point.force += one.force - h * (one.stiffness * contact_points_[one.point].v);
      point.inertia += h * h * one.stiffness + h * one.damping;
    }
    helix_step(strand, motion_.elements, motion_.points, q_, rates_, h, scratch, change_);
    find_velocities_after();
    if (!contacts_.let_go(after_) || again == kMostContactSteps) return;
  }
}

// Velocities are those at the end of the step without the part of `change_`.
void SuperHelixBody::find_points() {
  for (std::size_t i = 0; i < contact_points_.size(); ++i) {
    const std::size_t j = motion_.placed[i + 1];
    const HelixPoint& point = motion_.points[j];
    const double length = (i + 2 < places_.size() ? places_[i + 2] : places_[i + 1]) - places_[i];
    contact_points_[i] = {motion_.strand().line_density * length / 2, point.position, motion_.velocities[j]};
    without_contacts_[i] = {point.force, point.inertia};
  }
}

// A change of the rates moves points as if the root were held.
void SuperHelixBody::move_by_change() {
  HelixRoot held;
  held.frame = root_.frame;
  motion_.move(held, change_);
}

void SuperHelixBody::find_velocities_after() {
  move_by_change();
  for (std::size_t i = 0; i < after_.size(); ++i)
    after_[i] = contact_points_[i].v + motion_.velocities[motion_.placed[i + 1]];
}

Sizes SuperHelixBody::sizes() const {
  Sizes sizes;
  if (energy_) add(energy_->watch(), sizes);
  sizes[Concern::penetration] = contacts_.deepest();
  return sizes;
}

// False if all elements together turn the tip faster than light.
bool SuperHelixBody::is_sound() const {
  double turning = root_.spin.norm();
  for (Eigen::Index i = 0; i < q_.size() / 3; ++i)
    turning += rates_.segment<3>(3 * i).norm() * motion_.strand().lengths[i];
  return q_.allFinite() && root_.frame.position.norm() <= kFarthest && turning * places_.back() <= kFastest;
}

HelixMotion SuperHelixBody::motion_at(particles::Input q, particles::Input rate) const {
  HelixMotion motion(motion_.strand(), places_);
  const HelixRoot root = root_at(q, rate);
  motion.place(root.frame, q.tail(q_.size()));
  motion.move(root, rate.tail(q_.size()));
  return motion;
}

void SuperHelixBody::centre_line(particles::Input q, particles::Input rate, particles::Output x,
                                 particles::Output v) const {
  const HelixMotion motion = motion_at(q, rate);
  for (int i = 0; i < points(); ++i) {
    x.segment<3>(3 * i) = motion.points[motion.placed[i]].position;
    v.segment<3>(3 * i) = motion.velocities[motion.placed[i]];
  }
}

BodyMeasures SuperHelixBody::measure(particles::Input q, particles::Input rate) const {
  const HelixMotion motion = motion_at(q, rate);
  BodyMeasures sum;
  const bool present = has_momentum_ && q.tail(q_.size()) == q_ && rate.tail(q_.size()) == rates_;
  sum.kinetic = present ? momentum_.kinetic_energy() : kinetic_energy(motion);
  sum.potential =
      elastic_energy(motion.strand(), q.tail(q_.size())) + weight_energy(surroundings_.gravity, motion);
  for (std::size_t j = 0; j < motion.points.size(); ++j) {
    const Vector3d momentum = motion.strand().line_density * motion.weights[j] * motion.velocities[j];
    sum.momentum += momentum;
    sum.angular_momentum += motion.points[j].position.cross(momentum);
  }
  sum.tip = motion.points[motion.placed.back()].position;
  return sum;
}

HelixEnergy::HelixEnergy(const HelixStrand& strand, const HelixSurroundings& surroundings)
    : surroundings_(surroundings),
      mass_(strand.line_density * strand.lengths.sum()),
      watch_(mass_, strand.lengths.sum(), surroundings.gravity.norm(), surroundings.drag) {}

void HelixEnergy::read_motion(const HelixMotion& motion, const std::vector<Vector3d>& velocities,
                              const Vector3d& root_velocity) {
  now_.kinetic = 0;
  momentum_.setZero();
  for (std::size_t j = 0; j < motion.points.size(); ++j) {
    const double mass = motion.strand().line_density * motion.weights[j];
    const Vector3d v = velocities[j] - root_velocity;
    now_.kinetic += mass / 2 * v.squaredNorm();
    momentum_ += mass * v;
  }
}

void HelixEnergy::read_place(const HelixMotion& motion, Input q) {
  const Vector3d root = motion.elements.front().start.position;
  now_.elastic = elastic_energy(motion.strand(), q);
  now_.weight = weight_energy(surroundings_.gravity, motion) + mass_ * surroundings_.gravity.dot(root);
}

void HelixEnergy::before_step(const HelixMotion& motion, Input q, const Vector3d& before,
                              const Vector3d& after) {
  before_ = before;
  after_ = after;
  if (watch_.begun()) return;
  read_motion(motion, motion.velocities, before);
  read_place(motion, q);
  watch_.begin(now_);
}

void HelixEnergy::found(const HelixMotion& motion, const std::vector<Vector3d>& kept, double h,
                        const Vector3d& spin, Input rates, const ContactWork* contacts) {
  const HelixStrand& strand = motion.strand();
  const double drag = surroundings_.drag;
  const Vector3d root = motion.elements.front().start.position, changes = after_ - before_;
  Vector3d torque = Vector3d::Zero();
  work_ = contacts ? contacts->seen_from(after_) : 0;
  work_ -= changes.dot(momentum_ - mass_ / 2 * changes);
  in_contact_ = contacts != nullptr;
  for (std::size_t j = 0; j < motion.points.size(); ++j) {
    const HelixPoint& point = motion.points[j];
    torque += (point.position - root).cross(point.inertia * motion.velocities[j] - h * point.force);
    work_ -= h * drag * motion.weights[j] * (kept[j] - surroundings_.wind).dot(kept[j] - after_);
  }
  work_ += torque.dot(spin);
  for (int i = 0; i < strand.elements(); ++i) {
    const Vector3d rate = rates.segment<3>(3 * i);
    work_ -=
        h * surroundings_.relaxation_time * strand.lengths[i] *
        (strand.bend_rigidity * rate.head<2>().squaredNorm() + strand.twist_rigidity * rate[2] * rate[2]);
  }
  read_motion(motion, kept, after_);
}

void HelixEnergy::after_step(const HelixMotion& motion, Input q, double h) {
  read_place(motion, q);
  watch_.after_step(now_, work_, in_contact_, h);
}

}  // namespace hair
