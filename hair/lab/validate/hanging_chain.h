// A chain that hangs from a hinge: n masses on massless links of fixed length, in a plane, without bending;
// and its small oscillations. Mass i, counted from the top, hangs on link i.
//
// Let T_i = g sum_{j >= i} m_j be the tension of link i and q_i the sideways position of mass i (q of the
// hinge is 0):
//
//   m_i q_i'' = T_{i+1} (q_{i+1} - q_i) / l - T_i (q_i - q_{i-1}) / l.
//
// For equal masses a mode's w^2 is (g/l) x, with x a zero of the Laguerre polynomial L_n, and the
// amplitude of mass i is L_{n-i}(x). The equation above is then (j+1) L_{j+1} = (2j+1-x) L_j - j L_{j-1},
// j = n - i (D. Bernoulli 1732, for the chain; M. Abramowitz and I. A. Stegun, "Handbook of Mathematical
// Functions", 22.7.12, for the polynomials).
#pragma once

#include <Eigen/Core>

#include "particles/gravity.h"

namespace hair {

struct HangingChain {
  Eigen::VectorXd mass;                       // n, kg, from the top
  double link = 0.01;                         // m
  double gravity = particles::kEarthGravity;  // m/s^2
  double stretch = 1e-9;                      // T_0/EA, if the links are springs: as small as rounding allows

  int count() const { return static_cast<int>(mass.size()); }
  double tension(int i) const { return gravity * mass.tail(count() - i).sum(); }  // N, of link i
  double square_unit() const { return gravity / link; }                           // unit of w^2, 1/s^2
};

// The n zeros of L_n, increasing: eigenvalues of the symmetric tridiagonal matrix with 2j + 1 on its diagonal
// and j beside it (G. H. Golub and J. H. Welsch, Math. Comp. 23 (1969), 221), then one Newton step each.
Eigen::VectorXd laguerre_zeros(int n);

// The angles of the links in the mode with w^2 = (g/l) x, scaled so that the largest is 1.
Eigen::VectorXd mode_angles(const HangingChain& chain, double x);

// The effect of the amplitude on a mode's frequency: it is w (1 + c A^2 + ...), with A the largest angle of a
// link.
//
// With M_ij = l^2 sum_{k >= max(i,j)} m_k and G_i = l T_i the Lagrangian is
//
//   sum_ij M_ij cos(a_i - a_j) a_i' a_j' / 2 + sum_i G_i cos(a_i),
//
// and its mean over a period, with a = A f cos(wt), is stationary in A (G. B. Whitham, "Linear and Nonlinear
// Waves", 1974, section 14.2). Its fourth-order terms give c = -4 (tau + nu / w^2) / f'Mf, with
//
//   tau = -sum_ij M_ij (f_i - f_j)^2 f_i f_j / 32,   nu = sum_i G_i f_i^4 / 64.
//
// For one mass this is the pendulum's -1/16.
double softening(const HangingChain& chain, double x, const Eigen::VectorXd& angles);

// T/T0 of a pendulum with the amplitude `angle`, where T0 = 2 pi sqrt(l/g) is the period of a small swing:
//
//   T/T0 = (2/pi) K(sin(angle/2)) = 1 / agm(1, cos(angle/2)),
//
// with K the complete elliptic integral of the first kind and agm the arithmetic-geometric mean (L. D. Landau
// and E. M. Lifshitz, "Mechanics", section 11, problem 1; M. Abramowitz and I. A. Stegun, 17.6). 0 <= angle <
// pi.
double period_ratio(double angle);

}  // namespace hair
