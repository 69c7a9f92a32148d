// The frequency of an oscillation, from a signal: the fit of a sinusoid, without what the integrator made of
// it.
//
// An integrator changes a frequency: an oscillation x'' = -w^2 x, taken in steps of h, gets another frequency
// W. W is measured, and the functions undo_... compute w from it.
#pragma once

#include <Eigen/Core>

namespace hair {

// A sinusoid in a signal.
struct Sinusoid {
  double frequency = 0;  // rad for each sample; NaN if there is none or the fit does not converge
  double decay = 0;      // the amplitude's, for each sample
  double amplitude = 0;
  double residual = 0;  // root mean square of signal minus fit
};

// Fits exp(-decay k) (a cos(frequency k) + b sin(frequency k)) to samples k = 0, 1, ... by least squares with
// the Gauss-Newton method. The first guess of the frequency comes from the signal's sign changes; it must
// have at least three.
Sinusoid fit_sinusoid(const Eigen::VectorXd& samples);

// H6, for small oscillations across segments that don't stretch. Take the lecture's five steps at first order
// in the angles, for EA to infinity. Sideways, the length constraints contribute only the tension's part,
// -w^2 x; half of it is in the first and half in the second filter, each at its own position:
//
//   v(n+1/2) = v(n) - (h/2) w^2 x(n),   x(n+1) = x(n) + h v(n+1/2),   v(n+1) = v(n+1/2) - (h/2) w^2 x(n+1).
//
// (The springs' own products act only along the segments; the correction and its impulse are of second
// order.) This is the leapfrog method: x(n+1) - 2 x(n) + x(n-1) = -h^2 w^2 x(n). With x(n) = cos(W h n), 2
// cos(Wh) - 2 = -h^2 w^2, and
//
//   w = (2/h) sin(W h / 2).
//
// Now let the load stretch a segment by the fraction s = T/EA of its length. Each step makes it longer by
// that much, and the correction undoes it. So a fraction e of the kick h w^2 x is given at x(n+1), along the
// segment's direction there, instead of at x(n). The correction moves mass i of a chain by the sum of the
// stretches above it, at most n s l, which is a velocity of n s l / h compared with gravity's h g: e h^2 w^2
// <= n s x, with w^2 = (g/l) x. Then
//
//   x(n+1) - 2 x(n) + x(n-1) = -h^2 w^2 ((1 - e) x(n) + e x(n+1)),
//
// and at first order the amplitude decays by e h^2 w^2 / 2 in each step, and W is lower by the fraction e h^2
// w^2 / 4, at most n s x / 4 for any h.
double undo_leapfrog(double measured, double step);

// The classical Runge-Kutta method: a step multiplies by R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24, z = iwh (E.
// Hairer and G. Wanner, "Solving Ordinary Differential Equations II", IV.2). So, with y = wh,
//
//   W h = arg R = atan2(y - y^3/6, 1 - y^2/2 + y^4/24).
//
// The function solves this for y by Newton's method; for W h < 1.9.
double undo_runge_kutta_4(double measured, double step);

// The decay of the amplitude in a step: -log |R(iy)|, |R(iy)|^2 = 1 - y^6/72 + y^8/576.
double runge_kutta_4_decay(double y);

// H4, for springs with full products: a step divides by 1 - iwh, which turns the phase by W h = atan(wh) and
// divides the amplitude by sqrt(1 + (wh)^2) = 1 / cos(W h). w = tan(W h) / h; W h < pi/2.
double undo_implicit_euler(double measured, double step);

// H6, for springs with full products, such as bending, if lengths are right to first order. With c = (z^2/2)
// / (1 + z^2/2), z = wh, its two filters and the steps between them multiply (x, h v) by
//
//   (1 - c) (   1      1    )
//           ( -2 c  1 - 2 c ),
//
// This matrix has the determinant (1 - c)^2 and the trace 2 (1 - c)^2. So cos(W h) = 1 - c = 1 / (1 + z^2/2),
// and a step multiplies the amplitude by the same factor. W h < pi/2.
double undo_filters(double measured, double step);

}  // namespace hair
