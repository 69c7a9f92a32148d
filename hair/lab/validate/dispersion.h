// What an integrator makes of a frequency. An oscillation x'' = -w^2 x, taken in steps of h, comes out with
// another frequency W; what is measured is W, and these functions give w back.
#pragma once

namespace hair {

// H6, of small oscillations across segments that don't stretch. The lecture's five steps, at first order in
// the angles and as EA goes to infinity: lengths demand nothing of what goes sideways but the tension's part
// of it, -w^2 x, which is half in the first and half in the second filter, each at its own place:
//
//   v(n+1/2) = v(n) - (h/2) w^2 x(n),   x(n+1) = x(n) + h v(n+1/2),   v(n+1) = v(n+1/2) - (h/2) w^2 x(n+1).
//
// (The springs' own products act along the segments alone; the correction and its impulse are of second
// order.) That is the leapfrog method: x(n+1) - 2 x(n) + x(n-1) = -h^2 w^2 x(n), with x(n) = cos(W h n) 2
// cos(Wh) - 2 = -h^2 w^2, and
//
//   w = (2/h) sin(W h / 2).
//
// A segment that stretches by the part s = T/EA of its length under its load is made so much longer by each
// step, and the correction takes it back: a part e of the kick h w^2 x is not given at x(n), but, along the
// segment as it is then, at x(n+1). The correction moves mass i of a chain by the sum of the stretches above
// it, n s l at most, which is a velocity of n s l / h beside the gravity's h g: e h^2 w^2 <= n s x, with w^2
// = (g/l) x. Then
//
//   x(n+1) - 2 x(n) + x(n-1) = -h^2 w^2 ((1 - e) x(n) + e x(n+1)),
//
// and at first order the amplitude decays by e h^2 w^2 / 2 in each step and W is lower by the part e h^2 w^2
// / 4, at most n s x / 4, whatever h is.
double undo_leapfrog(double measured, double step);

// Runge and Kutta's classical method: a step multiplies by R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24, z = iwh (E.
// Hairer and G. Wanner, "Solving Ordinary Differential Equations II", IV.2), and so, with y = wh,
//
//   W h = arg R = atan2(y - y^3/6, 1 - y^2/2 + y^4/24).
//
// Solved for y by Newton's method; for W h < 1.9.
double undo_runge_kutta_4(double measured, double step);

// And what a step takes from the amplitude: -log |R(iy)|, |R(iy)|^2 = 1 - y^6/72 + y^8/576.
double runge_kutta_4_decay(double y);

// H4, of springs whose products it has: a step divides by 1 - iwh, which turns by W h = atan(wh) and divides the amplitude
// by sqrt(1 + (wh)^2) = 1 / cos(W h). w = tan(W h) / h; W h < pi/2.
double undo_implicit_euler(double measured, double step);

// H6, of springs whose products it has, such as bending, and where lengths are right to first order. With c =
// (z^2/2) / (1 + z^2/2), z = wh, its two filters and what is between them multiply (x, h v) by
//
//   (1 - c) (   1      1    )
//           ( -2 c  1 - 2 c ),
//
// of which the determinant is (1 - c)^2 and the trace 2 (1 - c)^2: so cos(W h) = 1 - c = 1 / (1 + z^2/2), and that is what the
// amplitude is multiplied by, too. W h < pi/2.
double undo_filters(double measured, double step);

}  // namespace hair
