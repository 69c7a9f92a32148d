// Stability theory: the largest step for which a method's errors don't grow, for linear systems.
//
//   M x'' = -K x - gamma M x'          masses M, stiffness K, drag gamma (1/s) proportional to mass
//
// The modes of K and M are independent of each other, so an explicit method sees oscillators
//
//   x'' = -omega^2 x - gamma x',    lambda = -gamma/2 +- sqrt(gamma^2/4 - omega^2),  zeta = gamma / (2 omega)
//
// and its limit is the smallest of their limits. That is not always the fastest oscillator's: with strong
// drag, gamma > sqrt(2) omega, forward Euler's limit is that of the slowest oscillator.
//
// A limit is a step, s; infinity if every step is stable, and 0 if no step is stable.
//
// With `growth` > 1 the functions return the largest step for which no error grows by more than this factor
// per step. A run of finitely many steps can't distinguish slow growth from none; this is the limit that it
// can detect.
//
// Sources: E. Hairer, S. P. Norsett and G. Wanner, "Solving Ordinary Differential Equations I" (1993), II.1;
// E. Hairer and G. Wanner, "Solving Ordinary Differential Equations II" (1996), IV.2 and IV.3; the rest is
// derived below.
#pragma once

#include <Eigen/Core>

#include "hair/simulation/simulation.h"

namespace hair {

struct Oscillator {
  double omega;      // 1/s, >= 0
  double gamma = 0;  // 1/s, >= 0
};

// The limits of P1's four methods; throws std::invalid_argument for others. Runge-Kutta methods multiply by a
// polynomial, |R(h lambda)| = growth: forward Euler 1 + z, midpoint 1 + z + z^2/2, RK4 1 + z + z^2/2 + z^3/6
// + z^4/24. Hence
//
//   forward Euler      2 zeta/omega for zeta <= 1, 2/(omega (zeta + sqrt(zeta^2 - 1))) beyond
//   symplectic Euler   2/omega, with drag 2 (sqrt(1 + zeta^2) - zeta)/omega
//   midpoint           no step is stable without drag
//   RK4                2 sqrt(2)/omega without drag, 2.785/|lambda| if lambda is real
double explicit_limit(Method method, const Oscillator& oscillator, double growth = 1);

// H4's limit. Its matrix has the stiffness P in place of K: a step is
//
//   (M + h gamma M + h^2 P) (v' - v) = -h K x - h gamma M v - h^2 P v,   x' = x + h v'.
//
// An error that grows as z^k satisfies (M + h gamma M + h^2 P) z^2 + (h^2 (K - P) - h gamma M - 2 M) z + M
// = 0. It first leaves the unit circle at z = -1, where 4 + 2 h gamma = h^2 mu with mu the largest
// eigenvalue of M^-1 (K - 2 P): h = (gamma + sqrt(gamma^2 + 4 mu)) / mu, no limit if mu <= 0. With the
// geometric term in tension, P = K, so mu < 0. Without it, P contains only stretching and bending, and K -
// P is the tension; hair without bending then has the limit 2/omega_t, that of an explicit method across
// the hair. `stiffness` and `in_matrix` are K and P, symmetric; `mass` is the diagonal of M.
double implicit_limit(const Eigen::VectorXd& mass, const Eigen::MatrixXd& stiffness,
                      const Eigen::MatrixXd& in_matrix, double gamma, double growth = 1);

// H6's limit, across a hair that keeps its lengths. With S = (1 + h gamma/2) M + h^2 P/2 a step is
//
//   S w = M v - h/2 K x,   x' = x + h w,   S v' = M w - h/2 K x'.
//
// The limit is the smallest h with an error z = -1; infinity if there is none below `most`. Without bending
// and drag (S = M) it is 2/omega_t. Both make S larger, so the search starts at half of 2/omega, with omega
// the fastest of K.
double predictor_corrector_limit(const Eigen::VectorXd& mass, const Eigen::MatrixXd& stiffness,
                                 const Eigen::MatrixXd& in_matrix, double gamma, double most,
                                 double growth = 1);

}  // namespace hair
