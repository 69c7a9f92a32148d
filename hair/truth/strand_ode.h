// A problem's strand as a system of ordinary differential equations. Of each particle but the root, from the root on,
// y has its position and then its velocity, six numbers: forces between neighbours, and between those that have one
// particle between them, make a band of df/dy. The forces are those of a simulation of the problem's scene, with
// products that are derivatives and nothing else. The root moves by itself.
//
// A strand that rests curved has a full matrix, for the frame at a joint depends on all joints before it. It is given
// the band alone: what is hard, stretching, is in there, and Newton's method converges as fast without the rest.
#pragma once

#include "hair/simulation/simulation.h"
#include "hair/truth/ode.h"
#include "hair/truth/problem.h"
#include "hair/truth/strand_root.h"

namespace hair {

// The problem's hair with products that are exact.
Description exact_description(const Problem& problem);

// Natural sizes of positions and velocities: the strand's length, and that length in the study's duration, or the
// largest velocity at the start if that is more.
struct Scales {
  double position, velocity;  // m, m/s
};
Scales strand_scales(const Problem& problem);

// Forces on particle i depend on i - kReach to i + kReach.
inline constexpr int kReach = 2;

class StrandOde : public Ode {
 public:
  // Copies what it needs of the problem. Throws what Simulation throws.
  explicit StrandOde(const Problem& problem);

  int size() const override { return 6 * (n_ - 1); }
  Eigen::VectorXd start() const override;
  Eigen::VectorXd scales() const override;
  std::vector<double> breaks() const override { return root_.breaks(); }
  void start_span(double t) override { root_.start_span(t); }
  void rates(double t, particles::Input y, particles::Output dy) override;
  int above() const override;
  int below() const override;
  bool jacobian(double t, particles::Input y, BandMatrix& df) override;
  particles::State state(double t, particles::Input y) override;

 private:
  void unpack(double t, particles::Input y);

  Scene scene_;
  Simulation simulation_;
  StrandRoot root_;
  int n_;      // particles
  int apart_;  // particles whose columns of df/dy have no row of the band in common
  Scales scales_;
  particles::State state_;
  Eigen::VectorXd force_, change_, by_x_, by_v_;
};

}  // namespace hair
