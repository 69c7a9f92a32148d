#include "hair/mass_spring/mass_spring_body.h"

#include <algorithm>

#include "hair/strand/measures.h"

namespace hair {
namespace {

constexpr double kDeepEnough = 1e-7;  // m: so small a push has no effect on lengths
constexpr int kMostMends = 20;

double energy(const std::vector<const particles::Force*>& parts, const Eigen::VectorXd& x) {
  double sum = 0;
  for (const particles::Force* part : parts) sum += part->energy(x);
  return sum;
}

}  // namespace

MassSpringBody::MassSpringBody(const StrandStart& start, const StepMethod& method,
                               const ForceOptions& options, bool collides, bool watched)
    : moving_(start.strand, start.state),
      method_(method),
      root_normal_(start.root_normal),
      collides_(collides) {
  add_forces(options, start, moving_);
  if (watched)
    energy_.emplace(moving_, options.gravity, options.drag, !method.goes_straight_on, method.read_every);
}

void MassSpringBody::restart(const StrandStart& start) {
  moving_.state = start.state;
  set_root_frame(start.strand.root_tangent, start.root_normal);
  if (energy_) energy_->restart();
  sizes_ = {};
  steps_ = unmended_steps_ = solves_ = unconverged_ = 0;
}

void MassSpringBody::set_root_frame(const Vector3d& tangent, const Vector3d& normal) {
  moving_.strand.root_tangent = tangent;
  root_normal_ = normal;
  if (moving_.rest_curvature) moving_.rest_curvature->set_root_normal(normal);
  if (energy_) energy_->root_turned();
}

void MassSpringBody::read(particles::Output q, particles::Output rate) const {
  q = moving_.state.x;
  rate = moving_.state.v;
}

void MassSpringBody::write(particles::Input q, particles::Input rate) {
  moving_.state.x = q;
  moving_.state.v = rate;
  if (energy_) energy_->restart();
}

// The root is a particle whose velocity brings it to its position.
void MassSpringBody::set_root(const Root& root) {
  set_root_velocity(root.velocity);
  if (moving_.strand.clamped) set_root_frame(root.tangent, root.normal);
}

std::optional<Stage> MassSpringBody::step(const BodyStep& step, const particles::Scratch& scratch,
                                          Work& work) {
  particles::Scratch memory = scratch;  // a writable view
  const bool collides = collides_ && !step.obstacles.empty();
  auto x_before = memory.col(method_.scratch), v_before = memory.col(method_.scratch + 1);
  const bool looks_at_way = energy_ && method_.keeps_lengths;
  if (collides || looks_at_way) x_before = moving_.state.x;
  if (energy_ && (moving_.drag || looks_at_way)) v_before = moving_.state.v;
  if (moving_.point_forces) moving_.point_forces->set(step.forces);
  if (energy_) energy_->before_step();

  const particles::Scratch for_method = memory.leftCols(method_.scratch);
  const StepOutcome outcome = method_.step(moving_, {step.h, step.tolerance}, for_method);
  if (looks_at_way) energy_->moved(step.h, x_before, v_before);
  return finish(step, x_before, v_before, for_method, outcome, work);
}

std::optional<Stage> MassSpringBody::step_to(const BodyStep& step, particles::Output x, particles::Output v,
                                             const StepOutcome& outcome, Work& work) {
  if (energy_) energy_->before_step();
  moving_.state.x.swap(x);
  moving_.state.v.swap(v);
  Eigen::MatrixXd none;
  return finish(step, x, v, none, outcome, work);
}

std::optional<Stage> MassSpringBody::finish(const BodyStep& step, particles::Input x_before,
                                            particles::Input v_before, const particles::Scratch& scratch,
                                            const StepOutcome& outcome, Work& work) {
  ++work.strand_steps;
  work.solver_steps += outcome.solver_steps;
  work.plain_solves += outcome.plain_solves;
  work.correction_steps += outcome.correction_steps;
  work.solves += outcome.solves;
  work.unconverged += outcome.unconverged;
  solves_ += outcome.solves;
  unconverged_ += outcome.unconverged;
  if (!is_sound(moving_.state)) return outcome.suspect;

  Collisions collisions;
  if (collides_ && !step.obstacles.empty()) {
    collisions = collide(step, x_before, scratch);
    work.contacts += collisions.contacts;
    work.unmended += !collisions.mended;
    work.penetration = std::max(work.penetration, collisions.penetration);
    if (!is_sound(moving_.state)) return Stage::collision;
  }
  if (energy_) watch(step.h, v_before, outcome, collisions);
  return {};
}

// Pushing particles out of obstacles changes lengths, and correcting lengths moves particles into obstacles
// again, but less each time. The obstacles are last.
MassSpringBody::Collisions MassSpringBody::collide(const BodyStep& step, particles::Input x_before,
                                                   const particles::Scratch& scratch) {
  Collisions all;
  for (int pass = 0;; ++pass) {
    const CollisionReport report =
        hair::collide(step.obstacles, moving_.particles, step.h, x_before, moving_.state);
    if (pass == 0) all.contacts = report.contacts;
    all.work.work += report.work;
    all.work.impulse += report.impulse;
    all.penetration = report.penetration;
    if (!method_.mend || report.deepest <= kDeepEnough) return all;
    if (pass == kMostMends) {
      all.mended = false;
      return all;
    }
    method_.mend(moving_, scratch);
  }
}

void MassSpringBody::watch(double h, particles::Input v_before, const StepOutcome& outcome,
                           const Collisions& collisions) {
  ++steps_;
  unmended_steps_ += !collisions.mended;
  energy_->after_step(h, v_before, collisions.contacts > 0 ? &collisions.work : nullptr);
  add(energy_->watch(), sizes_);
  sizes_[Concern::stretching] = energy_->watch().aside();
  const auto& [x, v] = moving_.state;
  sizes_[method_.keeps_lengths ? Concern::stretch : Concern::segment] = largest_stretch(moving_.strand, x);
  if (method_.keeps_lengths) sizes_[Concern::stretch_rate] = h * largest_stretch_rate(moving_.strand, x, v);
  sizes_[Concern::penetration] = collisions.penetration;
  sizes_[Concern::mends] =
      static_cast<double>(unmended_steps_) / static_cast<double>(std::max(steps_, kFewSteps));
  sizes_[Concern::unconverged] = outcome.residual;
  sizes_[Concern::solves] = share_of(unconverged_, solves_);
}

void MassSpringBody::centre_line(particles::Input q, particles::Input rate, particles::Output x,
                                 particles::Output v) const {
  x = q;
  v = rate;
}

BodyMeasures MassSpringBody::measure(particles::Input q, particles::Input rate) const {
  const Measures part = hair::measure(moving_.strand, moving_.particles, moving_.force, {q, rate});
  return {part.stretch,
          part.kinetic,
          part.potential,
          part.momentum,
          part.angular_momentum + Vector3d(q.head<3>()).cross(part.momentum),
          Vector3d(q.tail<3>())};
}

SpringEnergy::SpringEnergy(const MovingStrand& moving, const Vector3d& gravity, double drag,
                           bool with_stretching, int every)
    : moving_(moving),
      gravity_(gravity),
      with_stretching_(with_stretching),
      every_(every),
      watch_(moving.strand.mass.sum(), moving.strand.rest_length.sum(), gravity.norm(), drag) {}

double SpringEnergy::kinetic() const {
  const Eigen::VectorXd& v = moving_.state.v;
  double twice = 0;
  for (int i = 1; i < moving_.strand.count(); ++i)
    twice += moving_.strand.mass[i] * (v.segment<3>(3 * i) - root_velocity_).squaredNorm();
  return twice / 2;
}

double SpringEnergy::weight() const {
  const Eigen::VectorXd& x = moving_.state.x;
  Vector3d moment = Vector3d::Zero();
  for (int i = 1; i < moving_.strand.count(); ++i)
    moment += moving_.strand.mass[i] * (x.segment<3>(3 * i) - x.head<3>());
  return -gravity_.dot(moment);
}

Energies SpringEnergy::read() {
  const Eigen::VectorXd& x = moving_.state.x;
  const double stretching = energy(moving_.stretching, x);
  bending_ = energy(moving_.bending, x);
  return {.kinetic = kinetic(),
          .weight = weight(),
          .elastic = bending_ + (with_stretching_ ? stretching : 0),
          .aside = with_stretching_ ? 0 : stretching,
          .unmoved = unmoved_};
}

void SpringEnergy::restart() {
  watch_.restart();
  open_ = 0;
  work_ = time_ = 0;
  in_contact_ = false;
}

void SpringEnergy::before_step() {
  const Vector3d velocity = moving_.state.v.head<3>();
  const bool moved = velocity != root_velocity_, begins = !watch_.begun();
  if (open_ > 0 && (moved || turned_)) close();
  root_velocity_ = velocity;
  if (begins) {
    watch_.begin(read());
  } else if (moved || turned_) {
    Energies now = watch_.now();
    if (moved) now.kinetic = kinetic();
    if (turned_) {
      now.elastic -= bending_;
      bending_ = energy(moving_.bending, moving_.state.x);
      now.elastic += bending_;
    }
    watch_.root_moved(now);
  }
  turned_ = false;
}

void SpringEnergy::moved(double h, particles::Input x_before, particles::Input v_before) {
  const auto& [x, v] = moving_.state;
  double twice = 0;
  for (int i = 1; i < moving_.strand.count(); ++i) {
    const Vector3d velocity = (v_before.segment<3>(3 * i) + v.segment<3>(3 * i)) / 2;
    twice +=
        moving_.strand.mass[i] *
        (velocity - root_velocity_).dot(velocity - (x.segment<3>(3 * i) - x_before.segment<3>(3 * i)) / h);
  }
  unmoved_ = std::max(twice / 2, 0.0);
}

void SpringEnergy::after_step(double h, particles::Input v_before, const ContactWork* contacts) {
  if (moving_.drag) work_ += moving_.drag->work(h, v_before, moving_.state.v, root_velocity_);
  if (contacts) {
    work_ += contacts->seen_from(root_velocity_);
    in_contact_ = true;
  }
  time_ += h;
  if (++open_ == every_) close();
}

void SpringEnergy::close() {
  watch_.after_step(read(), work_, in_contact_, time_);
  open_ = 0;
  work_ = time_ = 0;
  in_contact_ = false;
}

}  // namespace hair
