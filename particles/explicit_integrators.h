// P1. Four explicit integrators of x' = v, v' = a(x, v). Each function takes one step of h seconds, from the
// state at t in x and v to the state at t + h in the same place.
//
//                      order   evaluations of a   source
//   forward_euler        1            1           Hairer, Norsett and Wanner, "Solving Ordinary Differential
//   symplectic_euler     1            1           Equations I" (1993), sections I.7 and II.1; symplectic: Hairer,
//   midpoint             2            2           Lubich and Wanner, "Geometric Numerical Integration" (2006),
//   runge_kutta_4        4            4           equation (I.1.9)
//
// The number of evaluations is part of the contract: it is what a step costs. h may have either sign; h = 0
// changes nothing. x and v have 3n entries and don't overlap. What overflows becomes an infinity or a NaN in x
// or v: the caller looks for it, the integrator does not.
#pragma once

#include "particles/dynamics.h"

namespace particles {

// Columns of 3n numbers that `scratch` has: as many as any of the four could need.
inline constexpr int kIntegratorScratch = 10;

// x(t+h) = x + h v,  v(t+h) = v + h a(x, v): both from the state at t.
void forward_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch);

// v(t+h) = v + h a(x, v),  x(t+h) = x + h v(t+h): the new velocity moves the particles.
void symplectic_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch);

// A forward Euler step of h/2 to the middle of the interval, then from the state at t a step of h with the
// velocity and the acceleration found there.
void midpoint(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch);

// The classical method of Runge and Kutta: slopes at t, twice at t + h/2, and at t + h, weighted 1:2:2:1.
void runge_kutta_4(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch);

}  // namespace particles
