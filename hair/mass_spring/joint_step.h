// A step of strands that something couples: they are one system, and not stepped strand by strand.
#pragma once

#include <optional>
#include <span>

#include "hair/mass_spring/mesh_record.h"
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

  // The strands start anew: what was remembered is forgotten.
  virtual void restart() = 0;

  // J, of what couples the strands, at positions x of all of them; what is remembered is that of now.
  virtual double energy(particles::Input x) const = 0;

  // How often a particle of this strand went through what couples others, so far.
  virtual int passes(int strand) const = 0;

  // What nothing gave all strands together, as EnergyWatch has it of one strand; 0 if nobody watches.
  virtual double gain() const = 0;
  virtual double contact_gain() const = 0;
  virtual double loss() const = 0;

  virtual const MeshRecord& record() const = 0;
};

}  // namespace hair
