// A problem's strand whose segments keep their lengths: what a strand becomes as EA grows without bound, with all
// its other forces. Index-reduced equations of motion: y has for each segment, from the root on, its direction u and
// the direction's rate w = u', six numbers, and the tensions T follow from |u| = 1, twice differentiated. With
// segment i between particles i and i + 1, of lengths l, masses m and other forces f,
//
//   a_i = (f_i + T_i u_i - T_{i-1} u_{i-1}) / m_i,   a_0 the root's,   u_i' = w_i,   w_i' = (a_{i+1} - a_i) / l_i,
//   u_i . (a_{i+1} - a_i) = -l_i |w_i|^2:   a tridiagonal system for T, solved directly.
//
// Positions are sums of l_i u_i / |u_i|, so that lengths are exact whatever errors |u| has, and of w what is
// perpendicular to u counts. E. Hairer and G. Wanner, "Solving Ordinary Differential Equations II" (1996), section
// VII.1, for what index reduction is.
#pragma once

#include "hair/simulation/simulation.h"
#include "hair/truth/ode.h"
#include "hair/truth/problem.h"
#include "hair/truth/strand_root.h"

namespace hair {

class RigidStrandOde : public Ode {
 public:
  // Copies what it needs of the problem. Throws what Simulation throws.
  explicit RigidStrandOde(const Problem& problem);

  int size() const override { return 6 * segments_; }
  Eigen::VectorXd start() const override;
  Eigen::VectorXd scales() const override;
  std::vector<double> breaks() const override { return root_.breaks(); }
  void start_span(double t) override { root_.start_span(t); }
  void rates(double t, particles::Input y, particles::Output dy) override;
  particles::State state(double t, particles::Input y) override;

  // By how much the tensions would stretch the strand that the problem has, all segments together: the most
  // since it was made, m. What sets this motion apart from that strand's, but for a factor of the order of 1.
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
  Eigen::Matrix3Xd u_, w_, a_;  // of segments, segments, particles
  Eigen::VectorXd tension_, diagonal_;
  particles::State state_;
  Eigen::VectorXd force_;
  double stretch_ = 0;
};

// Does it start as one whose segments have always kept their lengths, so that it has such a limit? To 1e-9 of the
// lengths, and of the velocities' size.
bool starts_rigid(const Problem& problem);

// How hard a strand is to stretch, in units of hair of the same mass for each metre: whatever its radius, the EA of a
// fibre is E / density times that mass.
double times_the_ea_of_hair(const Strand& strand);

}  // namespace hair
