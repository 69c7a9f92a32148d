// The books of guides that a control mesh makes one system. Each guide has books of its own (energy_watch.h),
// in which the mesh's forces are no work: what they do there shows as a gain. Here it is added up over all
// guides, and a step of h seconds adds
//
//   E1 - E0 + h sum over guides of F . V                                                         J
//
// of the links and strips: E, what they hold; F, the sum of their forces on a guide at the step's end; V, its
// root's velocity. For guides' books are in the frames of their roots, and -h F . V is the work of these.
// Where nothing is wrong the sum is 0 less what implicit Euler damps: -sum of m |v1 - v0|^2 / 2 - sum of k
// |d1 - d0|^2 / 2, of links' stretches d, but for frames, which turn during a step (frame_torque.h): they are
// right to first order.
//
// What a link no longer holds since it is weaker is no gain, and no loss that a gain could hide behind. What
// a root's frame gives links when it turns is work that came in. Strips that are found at the start of a step
// begin to hold energy then, which nothing gave: it is counted. Steps in which a guide touches anything, an
// obstacle or a strip, are in a row of their own. Rows, gains and losses are those of EnergyWatch.
#pragma once

#include <utility>
#include <vector>

#include "hair/strand/energy_watch.h"

namespace hair {

// What a mesh holds around a step, J; strips with the contacts of this step.
struct MeshEnergies {
  double links_before = 0, links_after = 0;  // with the strengths of the step's start
  double strips_before = 0, strips_after = 0;
  double root_work = 0;  // -h sum of F . V
  bool contacts = false;
};

class LinkedEnergy {
 public:
  // The guides' books, which must outlive this.
  explicit LinkedEnergy(std::vector<const EnergyWatch*> guides) : guides_(std::move(guides)) {}

  void restart();

  // After a step, and after the guides' books have it.
  void after_step(const MeshEnergies& mesh);

  // As EnergyWatch has them, of all guides together, relative to what all have and got.
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
