// Guides of masses and springs that a control mesh makes one system, and its steps by implicit Euler (H4).
//
// In each step, frames of particles and contacts are those of its start (H9). Friction changes velocities;
// then one implicit solve moves all particles, with links and strips in its matrix, preconditioned by the
// strands' own bands; then each strand collides; then links remember their stretches, and broken links are
// recorded.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hair/linked_guides/control_mesh.h"
#include "hair/linked_guides/linked_force.h"
#include "hair/linked_guides/strip_contacts.h"
#include "hair/mass_spring/mass_spring_body.h"
#include "hair/mass_spring/step_methods.h"
#include "hair/strand/energy_watch.h"

namespace hair {

// The mesh's energies around a step, J; strips have the contacts of this step.
struct MeshEnergies {
  double links_before = 0, links_after = 0;  // with the strengths of the step's start
  double strips_before = 0, strips_after = 0;
  double root_work = 0;  // -h sum of F . V
  bool contacts = false;
};

// The energy balance of guides that a control mesh makes one system. Each guide has its own balance
// (energy_watch.h), which does not count the mesh's forces as work: their work shows as a gain there. Here
// the gains of all guides are added, and a step of h seconds adds
//
//   E1 - E0 + h sum over guides of F . V                                                         J
//
// for links and strips: E is their energy; F is the sum of their forces on a guide at the step's end; V is
// its root's velocity. The guides' balances are in their roots' frames, so -h F . V is the work of these
// frames. In a correct step the sum is 0 less the damping of implicit Euler: -sum of m |v1 - v0|^2 / 2 -
// sum of k |d1 - d0|^2 / 2, with d the links' stretches. Frames that turn during a step (frame_torque.h)
// are right only to first order.
//
// A weaker link holds less energy: this is no gain, and no loss that could hide a gain. The energy that a
// turning root frame gives to links counts as work from outside. Strips found at the start of a step begin to
// hold energy from nowhere, which counts as a gain. Steps in which a guide touches an obstacle or a strip are
// in a row of their own. Rows, gains and losses are those of EnergyWatch.
class LinkedEnergy {
 public:
  // The guides' energy balances must outlive this object.
  explicit LinkedEnergy(std::vector<const EnergyWatch*> guides) : guides_(std::move(guides)) {}

  void restart();

  // Call this after a step, when the guides' balances include it.
  void after_step(const MeshEnergies& mesh);

  // As in EnergyWatch, for all guides together, relative to their whole energy and input.
  double gain() const { return gain_; }
  double contact_gain() const { return contact_gain_; }
  double loss() const { return loss_; }

 private:
  std::vector<const EnergyWatch*> guides_;
  bool begun_ = false;
  double links_ = 0, strips_ = 0;  // at the end of the last step
  EnergyRow free_, in_contact_;
  double scale_ = 0, gain_ = 0, contact_gain_ = 0, loss_ = 0;
};

// The method of each of these strands. Links carry energy from strand to strand, so the strands have a common
// energy balance (LinkedEnergy).
extern const StepMethod kLinkedImplicitEuler;

// One system of guides that a mesh couples: they can't be stepped strand by strand.
class LinkedGuides {
 public:
  // Throws std::invalid_argument for a mesh with indices or numbers out of bounds, and for guides that are
  // not clamped: their roots have no frame. Keeps references to the strands. watched: the record also has
  // the energy that wearing links lose.
  LinkedGuides(std::vector<MassSpringBody*> strands, const ControlMesh& mesh, bool watched);
  LinkedGuides(const LinkedGuides&) = delete;
  LinkedGuides& operator=(const LinkedGuides&) = delete;

  // One step of all strands, including collisions. broke[i]: nothing, or the stage in which strand i broke.
  // Adds to `work`.
  void step(const BodyStep& step, std::span<std::optional<Stage>> broke, Work& work);

  // The strands start anew: this object forgets its memory.
  void restart();

  // The energy of the coupling, J, at positions x of all strands, with the memory as it is now.
  double energy(particles::Input x) const;

  // The number of times that a particle of this strand went through the coupling of others so far.
  int passes(int strand) const { return contacts_.passes(strand); }

  // The energy gain of all strands together, as in EnergyWatch for one strand; 0 if it is not watched.
  double gain() const { return books_ ? books_->gain() : 0; }
  double contact_gain() const { return books_ ? books_->contact_gain() : 0; }
  double loss() const { return books_ ? books_->loss() : 0; }

  const MeshRecord& record() const { return record_; }

 private:
  Eigen::VectorBlock<Eigen::VectorXd> part(Eigen::VectorXd& all, std::size_t strand) const;
  void gather();
  void add_frames(std::size_t i, particles::Input x, std::span<Matrix3d> frames) const;
  double links_hold() const;
  double strips_hold() const;
  double root_work(double h);
  void remember();
  void touch(double h);

  std::vector<MassSpringBody*> strands_;
  std::vector<int> first_;  // the first particle of each strand, and the number of all
  ControlMesh mesh_;
  bool watched_;
  std::optional<LinkedEnergy> books_;
  MeshState held_;
  LinkedForce force_;
  StripContacts contacts_;
  particles::Particles particles_;
  Eigen::VectorXd inverse_mass_, tangents_;
  particles::State state_;
  Eigen::MatrixXd scratch_;
  Eigen::VectorXd mesh_force_;  // at a step's end
  Eigen::VectorXd before_;      // the largest stretches before the present step
  MeshRecord record_;
  long steps_ = 0;
};

}  // namespace hair
