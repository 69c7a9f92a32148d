#include "hair/mass_spring/mass_spring_body.h"

#include <algorithm>

#include "hair/strand/measures.h"

namespace hair {

namespace {

constexpr double kDeepEnough = 1e-7;  // m: so small a push has no effect on lengths
constexpr int kMostMends = 20;

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

}  // namespace hair
