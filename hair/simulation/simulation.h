// Strands that move: assembled once from plain data, with only the parts that the data ask for.
//
// A strand of masses and springs has a stretch part if EA > 0, a bending part if EI > 0, springs that skip a particle if
// skip_rigidity > 0, a rest curvature instead of angular springs if it has a rest shape; gravity and drag if
// they are not 0. A simulation without obstacles has no collision stage. Nothing couples strands, and so each
// is stepped by itself.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "hair/mass_spring/mass_spring_body.h"
#include "hair/simulation/description.h"
#include "hair/strand/blow_up.h"
#include "hair/strand/body.h"

namespace hair {

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

  // Back to the start, and on from there in steps of `description.step`. Only states, root frames, obstacles and the step
  // may differ from the original description: of strands of masses and springs nothing is assembled anew. Work is counted
  // from 0. Throws std::invalid_argument for other strands or obstacles, and a step that is not > 0.
  void restart(const Description& description);

  double time() const { return static_cast<double>(steps_) * step_.h; }  // s
  long steps() const { return steps_; }
  const Work& work() const { return work_; }

  int strands() const { return static_cast<int>(bodies_.size()); }
  Body& body(int i) { return *bodies_.at(i); }
  const Body& body(int i) const { return *bodies_.at(i); }
  const std::vector<Obstacle>& obstacles() const { return obstacles_; }  // where they are now

  // Of a strand of masses and springs. Throws std::out_of_range for another one.
  const Strand& strand(int i) const { return springs_.at(i)->moving().strand; }
  const particles::Particles& particles(int i) const { return springs_.at(i)->moving().particles; }
  const particles::State& state(int i) const { return springs_.at(i)->moving().state; }
  const particles::Force& force(int i) const {
    return springs_.at(i)->moving().force;
  }  // all that acts, but obstacles

  // From the next step on. Throw std::invalid_argument for what is not finite, or directions that are not of length
  // 1. The normal is that of a rest curvature; to other strands it does not matter.
  void set_root(int strand, const Root& root);
  void set_root_velocity(int strand, const Vector3d& velocity);  // m/s; of a strand of masses and springs
  void set_root_frame(int strand, const Vector3d& tangent,
                      const Vector3d& normal);                         // of such a clamped strand
  void set_obstacle_velocity(int obstacle, const Vector3d& velocity);  // m/s

 private:
  std::vector<std::unique_ptr<Body>> bodies_;
  std::vector<MassSpringBody*> springs_;  // the first of them
  std::vector<Obstacle> obstacles_;
  struct {
    double h, tolerance;
  } step_;
  Eigen::MatrixXd scratch_;  // shared by the strands, which take turns
  long steps_ = 0;
  Work work_;
  std::optional<BlowUp> blow_up_;
};

}  // namespace hair
