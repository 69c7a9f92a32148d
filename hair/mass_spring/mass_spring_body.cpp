#include "hair/mass_spring/mass_spring_body.h"

#include <algorithm>

#include "hair/strand/measures.h"

namespace hair {

namespace {

constexpr double kDeepEnough =
    1e-7;  // m: what a particle that is pushed out so far does to lengths is nothing
constexpr int kMostMends = 20;

}  // namespace

MassSpringBody::MassSpringBody(const StrandStart& start, const StepMethod& method,
                               const ForceOptions& options, bool collides)
    : moving_(start.strand, start.state), method_(method), collides_(collides) {
  add_forces(options, start, method.needs_definite_force, moving_);
}

void MassSpringBody::restart(const StrandStart& start) {
  moving_.state = start.state;
  set_root_frame(start.strand.root_tangent, start.root_normal);
}

void MassSpringBody::set_root_frame(const Vector3d& tangent, const Vector3d& normal) {
  moving_.strand.root_tangent = tangent;
  for (RestCurvature* rest : moving_.rest_curvatures) rest->set_root_normal(normal);
}

void MassSpringBody::read(particles::Output q, particles::Output rate) const {
  q = moving_.state.x;
  rate = moving_.state.v;
}

void MassSpringBody::write(particles::Input q, particles::Input rate) {
  moving_.state.x = q;
  moving_.state.v = rate;
}

// The root is a particle that moves by its velocity: that brings it to its position.
void MassSpringBody::set_root(const Root& root) {
  set_root_velocity(root.velocity);
  if (moving_.strand.clamped) set_root_frame(root.tangent, root.normal);
}

std::optional<Stage> MassSpringBody::step(const BodyStep& step, const particles::Scratch& scratch,
                                          Work& work) {
  particles::Scratch memory = scratch;  // a view that may be written to
  const bool collides = collides_ && !step.obstacles.empty();
  if (collides) memory.col(method_.scratch) = moving_.state.x;
  for (PointForces* forces : moving_.point_forces) forces->set(step.forces);

  const particles::Scratch for_method = memory.leftCols(method_.scratch);
  const StepOutcome outcome = method_.step(moving_, {step.h, step.tolerance}, for_method);
  ++work.strand_steps;
  work.solver_steps += outcome.solver_steps;
  work.plain_solves += outcome.plain_solves;
  work.correction_steps += outcome.correction_steps;
  work.halvings += outcome.halvings;
  work.unconverged += outcome.unconverged;
  if (!is_sound(moving_.state)) return outcome.suspect;

  if (!collides) return {};
  collide(step, memory.col(method_.scratch), for_method, work);
  if (!is_sound(moving_.state)) return Stage::collision;
  return {};
}

// Pushed out of obstacles, segments have other lengths, and with their lengths back particles are inside
// obstacles again, but less each time. The last word have the obstacles.
void MassSpringBody::collide(const BodyStep& step, particles::Input x_before,
                             const particles::Scratch& scratch, Work& work) {
  CollisionReport report;
  for (int pass = 0;; ++pass) {
    report = hair::collide(step.obstacles, moving_.particles, step.h, x_before, moving_.state);
    if (pass == 0) work.contacts += report.contacts;
    if (!method_.mend || report.deepest <= kDeepEnough || pass == kMostMends) break;
    method_.mend(moving_, scratch);
  }
  work.penetration = std::max(work.penetration, report.penetration);
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
