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
#pragma once

#include <utility>
#include <vector>

#include "hair/strand/energy_watch.h"

namespace hair {

// The mesh's energies around a step, J; strips have the contacts of this step.
struct MeshEnergies {
  double links_before = 0, links_after = 0;  // with the strengths of the step's start
  double strips_before = 0, strips_after = 0;
  double root_work = 0;  // -h sum of F . V
  bool contacts = false;
};

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

}  // namespace hair
