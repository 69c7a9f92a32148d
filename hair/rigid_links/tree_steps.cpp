#include "hair/rigid_links/tree_steps.h"

#include <utility>

#include "hair/strand/blow_up.h"

namespace hair {

TreeBase moved(const TreeBase& base, double t) {
  TreeBase after = base;
  const SpatialMotion &v = base.velocity, &a = base.acceleration;
  after.position += t * v.linear + t * t / 2 * a.linear;
  after.orientation = turn_by(t * v.angular + t * t / 2 * a.angular) * base.orientation;
  after.orientation.normalize();
  after.velocity += t * a;
  return after;
}

TreeSteps::TreeSteps(const LinkTree& tree, TreeForces forces)
    : system_(tree, std::move(forces)),
      a_(tree.rates()),
      stage_q_(tree.coordinates()),
      stage_rates_(tree.rates()),
      slope_(tree.coordinates()),
      sum_q_(tree.coordinates()),
      sum_rates_(tree.rates()) {}

void TreeSteps::euler(const TreeBase& base, double h, double implicit_h, std::span<const LinkForce> more,
                      Output q, Output rates) {
  system_.accelerations(base, q, rates, implicit_h, more, a_);
  rates += h * a_;
  system_.motion().turn(rates, h, q);
  drop_traces(rates);
  drop_traces(q);
}

// Quaternions are four numbers with a derivative here, and get the length 1 again at the end.
void TreeSteps::runge_kutta_4(const TreeBase& base, double h, std::span<const LinkForce> more, Output q,
                              Output rates) {
  constexpr double kAt[] = {0, 0.5, 0.5, 1}, kWeight[] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
  sum_q_ = stage_q_ = q;
  sum_rates_ = stage_rates_ = rates;
  for (int stage = 0; stage < 4; ++stage) {
    system_.accelerations(moved(base, kAt[stage] * h), stage_q_, stage_rates_, 0, more, a_);
    system_.motion().derivative(stage_q_, stage_rates_, slope_);
    sum_q_ += kWeight[stage] * h * slope_;
    sum_rates_ += kWeight[stage] * h * a_;
    if (stage == 3) break;
    stage_q_ = q + kAt[stage + 1] * h * slope_;
    stage_rates_ = rates + kAt[stage + 1] * h * a_;
    system_.tree().normalise(stage_q_);
  }
  q = sum_q_;
  rates = sum_rates_;
  system_.tree().normalise(q);
}

}  // namespace hair
