// A step of coupled strands: they are one system, so they can't be stepped strand by strand.
#pragma once

#include <optional>
#include <span>

#include "hair/linked_guides/mesh_record.h"
#include "hair/strand/body.h"

namespace hair {

class JointStep {
 public:
  JointStep() = default;
  virtual ~JointStep() = default;
  JointStep(const JointStep&) = delete;
  JointStep& operator=(const JointStep&) = delete;

  // One step of all strands, including collisions. broke[i]: nothing, or the stage in which strand i broke.
  // Adds to `work`.
  virtual void step(const BodyStep& step, std::span<std::optional<Stage>> broke, Work& work) = 0;

  // The strands start anew: this object forgets its memory.
  virtual void restart() = 0;

  // The energy of the coupling, J, at positions x of all strands, with the memory as it is now.
  virtual double energy(particles::Input x) const = 0;

  // The number of times that a particle of this strand went through the coupling of others so far.
  virtual int passes(int strand) const = 0;

  // The energy gain of all strands together, as in EnergyWatch for one strand; 0 if it is not watched.
  virtual double gain() const = 0;
  virtual double contact_gain() const = 0;
  virtual double loss() const = 0;

  virtual const MeshRecord& record() const = 0;
};

}  // namespace hair
