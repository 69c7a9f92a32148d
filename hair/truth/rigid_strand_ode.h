// A problem's strand with segments of fixed length: the limit of the strand for EA to infinity, with all its
// other forces. Index-reduced equations of motion: for each segment, from the root on, y has its direction u
// and the direction's rate w = u', six numbers. The tensions T follow from |u| = 1, differentiated twice.
// With segment i between particles i and i + 1, with lengths l, masses m and other forces f,
//
//   a_i = (f_i + T_i u_i - T_{i-1} u_{i-1}) / m_i, a_0 the root's, u_i' = w_i, w_i' = (a_{i+1} - a_i) / l_i,
//   u_i . (a_{i+1} - a_i) = -l_i |w_i|^2:   a tridiagonal system for T, solved directly.
//
// Positions are sums of l_i u_i / |u_i|, so that lengths are exact even if |u| has errors; only the part of w
// perpendicular to u counts. For index reduction see E. Hairer and G. Wanner, "Solving Ordinary Differential
// Equations II" (1996), section VII.1.
#pragma once

#include "hair/simulation/simulation.h"
#include "hair/truth/ode.h"
#include "hair/truth/problem.h"
#include "hair/truth/strand_ode.h"

namespace hair {

class RigidStrandOde : public Ode {
 public:
  // Copies the needed parts of the problem. Throws what Simulation throws.
  explicit RigidStrandOde(const Problem& problem);

  int size() const override { return 6 * segments_; }
  Eigen::VectorXd start() const override;
  Eigen::VectorXd scales() const override;
  std::vector<double> breaks() const override { return root_.breaks(); }
  void start_span(double t) override { root_.start_span(t); }
  void rates(double t, particles::Input y, particles::Output dy) override;
  particles::State state(double t, particles::Input y) override;

  // The largest total stretch, m, that the tensions would cause in the problem's strand since construction.
  // The distance between this motion and that strand's has this order of magnitude.
  double stretch() const { return stretch_; }

 private:
  void unpack(double t, particles::Input y);
  void find_tensions();

  Scene scene_;
  Simulation simulation_;  // without springs along the segments
  StrandRoot root_;
  int segments_;
  double velocity_scale_;  // 1/s
  RootMotion at_root_;
  Eigen::Matrix3Xd u_, w_, a_;  // for segments, segments, particles
  Eigen::VectorXd tension_, diagonal_;
  particles::State state_;
  Eigen::VectorXd force_;
  double stretch_ = 0;
};

// True if the strand starts as if its segments had always kept their lengths, so that it has such a limit.
// Tolerance: 1e-9 of the lengths, and of the velocities' size.
bool starts_rigid(const Problem& problem);

// The strand's EA, in units of hair with the same mass per metre: for any radius, the EA of a fibre is E /
// density times that mass.
double times_the_ea_of_hair(const Strand& strand);

}  // namespace hair
