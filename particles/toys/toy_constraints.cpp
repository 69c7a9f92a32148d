#include "particles/constraint_forces.h"
#include "particles/toys/toy_methods.h"

namespace particles {

namespace {

// a = W (f + J^T lambda): what the constraints leave of all other force. P2 solves for lambda.
class ConstrainedDynamics : public Dynamics {
 public:
  explicit ConstrainedDynamics(MovingToy& moving)
      : particles_(moving.toy.particles),
        constraints_(moving.toy.constraints),
        force_(moving.force),
        solves_(moving.solves),
        state_(moving.state),
        lambda_(Eigen::VectorXd::Zero(constraints_.rows())) {}

  void acceleration(Input x, Input v, Output a) override {
    state_.x = x;
    state_.v = v;
    a.setZero();
    force_.add_force(x, v, a);
    solves_.steps += solve_constraints(constraints_, particles_, state_, a, lambda_).steps;
    add_constraint_forces(constraints_, x, lambda_, a);
    for (int i = 0; i < particles_.count(); ++i) {
      if (particles_.is_pinned(i)) {
        a.segment<3>(3 * i).setZero();
      } else {
        a.segment<3>(3 * i) /= particles_.mass[i];
      }
    }
  }

 private:
  const Particles& particles_;
  const Constraints& constraints_;
  const Force& force_;
  SolveCount& solves_;
  State state_;
  Eigen::VectorXd lambda_;  // 0 at first: an exercise that reads it before it writes does the same each time
};

}  // namespace

std::unique_ptr<Dynamics> constrained_dynamics(MovingToy& moving) {
  return std::make_unique<ConstrainedDynamics>(moving);
}

}  // namespace particles
