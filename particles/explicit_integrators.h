// P1. Four explicit integrators of x' = v, v' = a(x, v). Each function takes one step of h seconds: x and v
// hold the state at t on entry and the state at t + h on return.
//
//                      order   evaluations of a
//   forward_euler        1            1
//   symplectic_euler     1            1
//   midpoint             2            2
//   runge_kutta_4        4            4
//
// Sources: E. Hairer, S. P. Norsett and G. Wanner, "Solving Ordinary Differential Equations I" (1993),
// sections I.7 and II.1; symplectic: E. Hairer, C. Lubich and G. Wanner, "Geometric Numerical Integration"
// (2006), equation (I.1.9).
//
// The number of evaluations is part of the contract: it is the cost of a step. h may have either sign; h = 0
// changes nothing. x and v have 3n entries, n >= 0, and don't overlap; a step allocates nothing. Values that
// overflow become infinities or NaNs in x and v, and every step still returns: the caller checks for them,
// not the integrator.
#pragma once

#include "particles/dynamics.h"

namespace particles {

// `scratch` has at least this many columns of 3n numbers, enough for each of the four functions.
inline constexpr int kIntegratorScratch = 10;

// x(t+h) = x + h v,  v(t+h) = v + h a(x, v): both from the state at t.
void forward_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch);

// v(t+h) = v + h a(x, v),  x(t+h) = x + h v(t+h): the new velocity moves the particles.
void symplectic_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch);

// A forward Euler step of h/2 to the middle of the interval, then a step of h from the state at t, with the
// velocity and the acceleration at the middle.
void midpoint(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch);

// The classical Runge-Kutta method: slopes at t, twice at t + h/2, and at t + h, weighted 1:2:2:1. Each slope
// is (v, a) at a state; that state starts from the state at t and follows the previous slope.
void runge_kutta_4(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch);

}  // namespace particles
