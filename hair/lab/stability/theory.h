// Theory of stability: the largest step with which a method's errors don't grow, for linear systems.
//
//   M x'' = -K x - gamma M x'          masses M, stiffness K, drag gamma (1/s) in proportion to mass
//
// K's and M's modes are independent of each other, so that an explicit method sees oscillators
//
//   x'' = -omega^2 x - gamma x',       lambda = -gamma/2 +- sqrt(gamma^2/4 - omega^2),  zeta = gamma / (2 omega)
//
// and its limit is the least of theirs. It is not always that of the fastest: drag that is as strong as
// gamma > sqrt(2) omega makes forward Euler's limit that of the slowest.
//
// A limit is a step, s; infinity where there is none, and 0 where no step is stable.
//
// `growth` >= 1 asks for something else: the largest step with which no error grows by more than this factor in a
// step. A run of finitely many steps can't tell slow growth from none; the limit of what it can is this one.
//
// Sources: E. Hairer, S. P. Norsett and G. Wanner, "Solving Ordinary Differential Equations I" (1993), II.1; E. Hairer
// and G. Wanner, "Solving Ordinary Differential Equations II" (1996), IV.2 and IV.3; the rest is derived below.
#pragma once

#include <Eigen/Core>

#include "hair/simulation/simulation.h"

namespace hair {

struct Oscillator {
  double omega;      // 1/s, >= 0
  double gamma = 0;  // 1/s, >= 0
};

// Of P1's four methods; others throw std::invalid_argument. Those of Runge and Kutta's kind multiply by a polynomial,
// |R(h lambda)| = growth: forward Euler 1 + z, midpoint 1 + z + z^2/2, RK4 1 + z + z^2/2 + z^3/6 + z^4/24. Hence
//
//   forward Euler      2 zeta/omega for zeta <= 1, 2/(omega (zeta + sqrt(zeta^2 - 1))) beyond
//   symplectic Euler   2/omega, with drag 2 (sqrt(1 + zeta^2) - zeta)/omega
//   midpoint           none is stable without drag
//   RK4                2 sqrt(2)/omega without drag, 2.785/|lambda| where lambda is real
double explicit_limit(Method method, const Oscillator& oscillator, double growth = 1);

// H4's, whose matrix has the stiffness P in place of K: a step is
//
//   (M + h gamma M + h^2 P) (v' - v) = -h K x - h gamma M v - h^2 P v,   x' = x + h v'.
//
// With errors z^k it holds (M + h gamma M + h^2 P) z^2 + (h^2 (K - P) - h gamma M - 2 M) z + M = 0, which first leaves
// the unit circle at z = -1, where 4 + 2 h gamma = h^2 mu with mu the largest eigenvalue of M^-1 (K - 2 P):
// h = (gamma + sqrt(gamma^2 + 4 mu)) / mu, none if mu <= 0. With the geometric term in tension P = K, and mu < 0; without
// it P holds the hair along and against bending, K - P is the tension, and hair without bending has 2/omega_t, the
// limit of an explicit method across the hair. `stiffness` and `in_matrix` are K and P, symmetric; mass: M's diagonal.
double implicit_limit(const Eigen::VectorXd& mass, const Eigen::MatrixXd& stiffness,
                      const Eigen::MatrixXd& in_matrix, double gamma, double growth = 1);

// H6's, across a hair that keeps its lengths. With S = (1 + h gamma/2) M + h^2 P/2 a step is
//
//   S w = M v - h/2 K x,   x' = x + h w,   S v' = M w - h/2 K x'.
//
// Its least h with an error z = -1; none below `most` is infinity. Without bending and drag (S = M) it is 2/omega_t; both
// make S larger, and so it is looked for from half of 2/omega up, omega the fastest of K.
double predictor_corrector_limit(const Eigen::VectorXd& mass, const Eigen::MatrixXd& stiffness,
                                 const Eigen::MatrixXd& in_matrix, double gamma, double most,
                                 double growth = 1);

// The matrix of that step: (x, v) at its end, 2n, of (x, v) at its start.
Eigen::MatrixXd predictor_corrector_step(const Eigen::VectorXd& mass, const Eigen::MatrixXd& stiffness,
                                         const Eigen::MatrixXd& in_matrix, double gamma, double h);

}  // namespace hair
