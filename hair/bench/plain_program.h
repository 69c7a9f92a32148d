// A minimal program for one kind of scene: straight strands without bending, with stretch springs, gravity
// and a method. It calls the exercises' functions directly. It does not check for blow-ups, counts nothing,
// and has no obstacles, motions, toys or pictures.
#pragma once

#include <vector>

#include "hair/simulation/simulation.h"

namespace hair_bench {

class PlainProgram {
 public:
  // Uses the description's strands, method (H4, H6, symplectic Euler or RK4), step and gravity along z.
  explicit PlainProgram(const hair::Description& description);

  void steps(int count);
  const particles::State& state(int strand) const { return strands_[strand].state; }

 private:
  struct Hair {
    hair::Strand strand;
    particles::Particles particles;
    Eigen::VectorXd inverse_mass;
    particles::State state;
  };

  hair::Method method_;
  double h_, tolerance_, gravity_;
  hair::GeometricTerm term_;
  std::vector<Hair> strands_;
  Eigen::MatrixXd scratch_;
};

}  // namespace hair_bench
