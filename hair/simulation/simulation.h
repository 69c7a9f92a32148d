// A simulation of strands, assembled once from plain data, with only the parts that the data need.
//
// A strand of masses and springs has a stretch part if EA > 0, a bending part if EI > 0, springs that skip a
// particle if skip_rigidity > 0, and a rest curvature instead of angular springs if it has a rest shape;
// gravity and drag if they are not 0. A simulation without obstacles has no collision stage. Without a
// control mesh nothing couples strands, so each is stepped separately, by any of the threads that the
// description asks for. The result is the same bit by bit for any number of them. With a mesh one thread
// steps all strands as one system.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "hair/linked_guides/linked_guides.h"
#include "hair/mass_spring/mass_spring_body.h"
#include "hair/simulation/description.h"
#include "hair/simulation/strand_threads.h"
#include "hair/strand/blow_up.h"
#include "hair/strand/body.h"

namespace hair {

class Simulation {
 public:
  // Throws std::invalid_argument for values that are out of bounds, not finite or of the wrong size.
  explicit Simulation(Description description);

  // One step of all strands. Allocates nothing, apart from ConjGrad's own memory.
  //
  // Returns a BlowUp if a strand breaks; the strand keeps the numbers of that step, which may be infinite or
  // NaN. After a blow-up, later calls do nothing and return the same BlowUp.
  std::optional<BlowUp> step();

  // From now on these strands are not stepped: they stay as they are, and break nothing. It is for strands
  // that nobody looks at. Throws std::invalid_argument if a control mesh couples strands, std::out_of_range
  // for a strand that does not exist.
  void leave_out(std::span<const int> strands);

  // Makes `steps` steps, or fewer if a strand breaks.
  std::optional<BlowUp> advance(long steps);

  // Restarts from the start with steps of `description.step`. Only states, root frames, obstacles and the
  // step may differ from the original description: nothing is assembled again for strands of masses and
  // springs. Work is counted from 0. Throws std::invalid_argument for other strands or obstacles, and for a
  // step that is not > 0.
  void restart(const Description& description);

  double time() const { return static_cast<double>(steps_) * step_.h; }  // s
  long steps() const { return steps_; }
  const Work& work() const { return work_; }
  const Watch& watch() const { return watch_; }

  // The energy of a control mesh, J, for its links and strips, at positions of all strands, one after the
  // other. It uses the links' present memory, and the strips' contacts of the last step.
  double mesh_energy(particles::Input x) const { return joint_ ? joint_->energy(x) : 0; }
  const MeshRecord* mesh_record() const { return joint_ ? &joint_->record() : nullptr; }  // null without

  int strands() const { return static_cast<int>(bodies_.size()); }
  Body& body(int i) { return *bodies_.at(i); }
  const Body& body(int i) const { return *bodies_.at(i); }
  const std::vector<Obstacle>& obstacles() const { return obstacles_; }  // at their present positions

  // For a strand of masses and springs. Throws std::out_of_range for another strand.
  const Strand& strand(int i) const { return springs_.at(i)->moving().strand; }
  const particles::Particles& particles(int i) const { return springs_.at(i)->moving().particles; }
  const particles::State& state(int i) const { return springs_.at(i)->moving().state; }
  const particles::Force& force(int i) const {
    return springs_.at(i)->moving().force;
  }  // all forces except those of obstacles

  // These take effect with the next step. They throw std::invalid_argument for values that are not finite,
  // and for directions that are not of length 1. The normal is that of a rest curvature; other strands ignore
  // it.
  void set_root(int strand, const Root& root);
  void set_root_velocity(int strand, const Vector3d& velocity);  // m/s; for a strand of masses and springs
  void set_root_frame(int strand, const Vector3d& tangent,
                      const Vector3d& normal);                             // for such a strand, clamped
  void set_obstacle_velocity(int obstacle, const Vector3d& velocity);      // m/s
  void set_obstacle_spin(int obstacle, const Vector3d& angular_velocity);  // rad/s; for a placed solid

 private:
  std::vector<std::unique_ptr<Body>> bodies_;
  std::vector<MassSpringBody*> springs_;  // the bodies of `strands`, which come first
  std::unique_ptr<LinkedGuides> joint_;   // for strands that a mesh couples
  std::vector<Obstacle> obstacles_;
  struct {
    double h, tolerance;
  } step_;
  bool watched_;
  std::vector<char> left_out_;  // for each strand
  struct Thread {
    Eigen::MatrixXd scratch;  // shared by the strands that it steps, one after the other
    Work work;
  };
  std::vector<Thread> own_;                  // one for each thread
  std::vector<std::optional<Stage>> broke_;  // in this step, by strand
  std::unique_ptr<StrandThreads> threads_;
  long steps_ = 0;
  Work work_;
  Watch watch_;
  std::optional<BlowUp> blow_up_;
};

}  // namespace hair
