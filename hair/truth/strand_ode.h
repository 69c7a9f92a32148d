// A problem's strand as a system of ordinary differential equations. For each particle except the root, from
// the root on, y has its position and then its velocity, six numbers: forces between neighbours and second
// neighbours make df/dy a band matrix. The forces are those of a simulation of the problem's scene, with
// exact products. The root moves independently.
//
// A strand that is curved at rest has a full matrix, because the frame at a joint depends on all joints
// before it. The solver gets only the band: it contains the stiff part, stretching, and Newton's method
// converges as fast without the rest.
#pragma once

#include <vector>

#include "hair/scene/scene.h"
#include "hair/simulation/simulation.h"
#include "hair/truth/ode.h"
#include "hair/truth/problem.h"

namespace hair {

// The root of a problem's strand: it keeps its velocity, or follows a motion.
struct RootMotion {
  Vector3d position, velocity, acceleration;  // m, m/s, m/s^2
  Vector3d tangent, normal;                   // unit vectors
};

class StrandRoot {
 public:
  // Keeps a reference to the scene, which has one strand.
  explicit StrandRoot(const Scene& scene);

  // True if tangent and normal change with time.
  bool turns() const { return turns_; }

  // The times of a motion's keys, at which the acceleration jumps. at() is valid between two of them: from
  // `time` to the next one after start_span(time), and before the first one initially.
  std::vector<double> breaks() const;
  void start_span(double time);

  RootMotion at(double time) const;

 private:
  RootMotion start_;                // its state before it moves
  const Motion* motion_ = nullptr;  // null: the root follows no motion
  bool turns_ = false;
  std::size_t next_key_ = 0;  // at the end of the span; motion_->keys.size() in the last span
};

// The problem's hair with exact products.
Description exact_description(const Problem& problem);

// Natural sizes of positions and velocities: the strand's length; and that length over the study's duration,
// or the largest velocity at the start if that is larger.
struct Scales {
  double position, velocity;  // m, m/s
};
Scales strand_scales(const Problem& problem);

// Forces on particle i depend on i - kReach to i + kReach.
inline constexpr int kReach = 2;

class StrandOde : public Ode {
 public:
  // Copies the needed parts of the problem. Throws what Simulation throws.
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
  int apart_;  // distance of particles whose columns of df/dy share no row of the band
  Scales scales_;
  particles::State state_;
  Eigen::VectorXd force_, change_, by_x_, by_v_;
};

}  // namespace hair
