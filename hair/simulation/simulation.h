// Strands that move: assembled once from plain data, with only the parts that the data ask for.
//
// A strand has a stretch part if EA > 0, a bending part if EI > 0, springs that skip a particle if
// skip_rigidity > 0, a rest curvature instead of angular springs if it has a rest shape; gravity and drag if
// they are not 0. A simulation without obstacles has no collision stage. Nothing couples strands, and so each
// is stepped by itself.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "hair/geometric_term.h"
#include "hair/mass_spring/methods.h"
#include "hair/mass_spring/moving_strand.h"
#include "hair/mass_spring/strand_forces.h"
#include "hair/strand.h"
#include "hair/strand/blow_up.h"
#include "hair/strand/material.h"
#include "hair/strand/obstacles.h"
#include "hair/strand/rest_shape.h"
#include "particles/state.h"

namespace hair {

enum class Method {
  forward_euler,        // P1
  symplectic_euler,     // P1
  midpoint,             // P1
  runge_kutta_4,        // P1
  implicit_euler,       // H4
  predictor_corrector,  // H6
  newton_euler          // H4's matrix, by Newton's method to convergence: for studies, not for hair
};

// A strand, and where it starts.
struct StrandStart {
  Strand strand;
  particles::State state;  // 3n each; the root goes on with the velocity that it has

  // Of a strand that is not straight at rest: two components for each segment (bend_components), and the normal
  // at the root that they count from. It must be clamped, and bends by its rest curvature instead of H2's springs.
  // Without effect if EI = 0: what resists no bend has no shape to go back to.
  Eigen::VectorXd rest_curvature = {};
  Vector3d root_normal = Vector3d::UnitX();
};

// A clamped strand that rests in the given shape, and starts there.
StrandStart start_at_rest(const Material& material, const RestShape& shape);

struct Description {
  std::vector<StrandStart> strands;
  Method method = Method::predictor_corrector;
  double step = 1.0 / 240;                   // s
  Vector3d gravity = Vector3d(0, 0, -9.81);  // m/s^2
  double drag = 0;                           // N s/m^2: for each metre of hair
  Vector3d wind = Vector3d::Zero();          // m/s, of the air that drags
  std::vector<Obstacle> obstacles;

  // Of implicit methods alone; newton_euler, whose result they don't change, has products of its own choice.
  GeometricTerm geometric_term = GeometricTerm::filtered;
  BendProduct bend_product = BendProduct::spd;
  double tolerance = 1e-10;  // of a solve's residual, relative to its right-hand side
};

// What all steps of all strands took so far.
struct Work {
  long strand_steps = 0;      // steps times strands
  long solver_steps = 0;      // of ConjGrad
  long correction_steps = 0;  // Newton steps: of the length correction, or of newton_euler
  long halvings = 0;          // of newton_euler's steps: each evaluates the forces once more
  long unconverged = 0;       // solves and corrections that ended above their tolerance
  long contacts = 0;          // particles that were pushed out of an obstacle
  double penetration = 0;     // m, the deepest that a particle was left in one
};

class Simulation {
 public:
  // Throws std::invalid_argument for what is out of bounds, not finite or of the wrong size, and for what
  // needs an exercise that the course leaves out.
  explicit Simulation(Description description);

  // One step of all strands. Allocates nothing beyond what ConjGrad does.
  //
  // Of a strand that breaks it says so, and leaves the strand as the step left it: with numbers that may be
  // infinite or NaN. That is the end: later calls do nothing and say the same.
  std::optional<BlowUp> step();

  // Steps until `steps` more are done, or a strand breaks.
  std::optional<BlowUp> advance(long steps);

  // Back to the start, and on from there in steps of `description.step`. The description is else that which the
  // simulation was made of, so that nothing is assembled anew. Work is counted from 0. Throws std::invalid_argument
  // for other strands or obstacles, and a step that is not > 0.
  void restart(const Description& description);

  double time() const { return static_cast<double>(steps_) * options_.h; }  // s
  long steps() const { return steps_; }
  const Work& work() const { return work_; }

  int strands() const { return static_cast<int>(strands_.size()); }
  const Strand& strand(int i) const { return strands_[i].strand; }
  const particles::Particles& particles(int i) const { return strands_[i].particles; }
  const particles::State& state(int i) const { return strands_[i].state; }
  const particles::Force& force(int i) const { return strands_[i].force; }  // all that acts, but obstacles
  const std::vector<Obstacle>& obstacles() const { return obstacles_; }     // where they are now

  // From the next step on. Throw std::invalid_argument for what is not finite, or directions that are not of length
  // 1. The normal is that of a rest curvature; to other strands it does not matter.
  void set_root_velocity(int strand, const Vector3d& velocity);                      // m/s
  void set_root_frame(int strand, const Vector3d& tangent, const Vector3d& normal);  // of a clamped strand
  void set_obstacle_velocity(int obstacle, const Vector3d& velocity);                // m/s

 private:
  std::optional<Stage> step_strand(MovingStrand& moving);
  void collide_strand(MovingStrand& moving);

  StepMethod method_;
  StepOptions options_;
  std::deque<MovingStrand> strands_;  // never moves what it holds
  std::vector<Obstacle> obstacles_;
  Eigen::MatrixXd scratch_;   // shared by the strands, which take turns
  Eigen::VectorXd x_before_;  // empty without obstacles
  long steps_ = 0;
  Work work_;
  std::optional<BlowUp> blow_up_;
};

}  // namespace hair
