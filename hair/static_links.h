// H9. Hairs that hold on to each other and keep out of each other: breakable links between neighbouring
// guides, and triangle strips between them. Source: the lecture, "Control Mesh"; J. T. Chang, J. Jin, Y. Yu,
// "A Practical Model for Hair Mutual Interactions" (SCA 2002).
//
// All linked guides are one system of n particles: x, v, f, dx, df and tangents have 3n entries. Directions
// (frames of particles, normals of contacts) are those of the step's start, and are held during the step.
// So every force here is linear in x, or 0; its product is exact, symmetric, and -df/dx is positive
// semi-definite. Functions named add_... add to their output. Good solutions allocate nothing. Errors:
// 1e-12 of the sizes of a result's terms.
#pragma once

#include <array>
#include <span>

#include "hair/static_link.h"
#include "particles/vectors.h"

namespace hair {

using Eigen::Matrix3d;
using particles::Input;
using particles::Output;

// ---- Links

// StaticLink is in hair/static_link.h. With R the frame of particle a, a rotation, a link's displacement is
//
//   d = x_b - (x_a + R offset)
//
// and its stretch |d| / length. frames[i] is that of particle i. largest[l] is the largest stretch that link
// l ever had: a link that has yielded stays weak. (3) to (5) hold it constant, too.

// (1) The part of its stiffness that a link still has: 1 if largest <= yields, else 0 if largest >= breaks;
// between yields and breaks it falls linearly. With yields = breaks the link breaks at once.
double link_strength(const StaticLink& link, double largest);

// (2) largest[l] = max(largest[l], the stretch of link l). The simulation calls this once after each step,
// with the positions at the step's end.
void remember_stretches(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input x,
                        Output largest);

// (3) E = sum over l of k s |d|^2 / 2, J, where s is the strength.
double link_energy(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input largest,
                   Input x);

// (4) f += -dE/dx: -k s d on b, and the opposite on a. So links preserve linear momentum, but not angular
// momentum: this force leaves out the torque that the arm R offset exerts on the guide of particle a. In
// simulations that part is given (hair/linked_guides/frame_torque.h).
void add_link_force(std::span<const StaticLink> links, std::span<const Matrix3d> frames, Input largest,
                    Input x, Output f);

// (5) df += (df/dx) dx.
void add_link_product(std::span<const StaticLink> links, Input largest, Input dx, Output df);

// ---- Strips
//
// A strip of triangles lies between two neighbouring guides; its corners are particles of both. A particle of
// a third hair that comes near a triangle is pushed away from it, along its normal. StripLaw is in
// hair/static_link.h, too.

// A particle near a triangle.
struct StripContact {
  int point = 0;
  std::array<int, 3> corners = {};    // the triangle's particles; `point` is none of them
  std::array<double, 3> shares = {};  // barycentric weights b_0, b_1, b_2 >= 0, their sum is 1
  Vector3d normal =
      Vector3d::UnitZ();  // n, of length 1: from the triangle to the side that the point belongs to
  double weight = 0;      // w: 0 to 1
};

// (6) With N = (x_1 - x_0) x (x_2 - x_0) of the corners,
//
//   normal = side N / |N|                side: +1 or -1
//   shares = the barycentric coordinates of the point's projection into the triangle's plane
//   weight = max(0, 1 - sum over j of shares_j |T . T_j|)
//
// T, T_j: tangents of the point and of the corners, of length 1, or 0. Returns false, with any contents in
// `contact`, if N is 0, a share is negative, or the point is `thickness` or more away from the plane.
//
// Chang, Jin and Yu's weight is 1 - Ta.Tb. A hair has no preferred end, so the sign of its tangent must not
// matter: hairs that lie side by side, parallel or antiparallel, merge (weight 0), and hairs that cross push
// each other (weight 1). Without the absolute value antiparallel hairs would get 2. Ta is one tangent here.
// They interpolate Tb; here each corner has a term of its own, so the signs of the T_j do not matter either.
bool touch_strip(int point, const std::array<int, 3>& corners, double side, double thickness, Input x,
                 Input tangents, StripContact& contact);

// (7) With the gap g = n . (x_point - sum over j of b_j x_corner_j) of each contact,
//
//   E = sum of k w max(0, r - g)^2 / 2, J.
double strip_energy(std::span<const StripContact> contacts, const StripLaw& law, Input x);

// (8) f += -dE/dx, with shares, normal and weight held: the pressure p = k w max(0, r - g) along n on the
// point, and b_j of the opposite on each corner. So contacts change neither linear momentum nor, right after
// (6), angular momentum.
void add_strip_force(std::span<const StripContact> contacts, const StripLaw& law, Input x, Output f);

// (9) df += (df/dx) dx. A contact with g >= r adds nothing.
void add_strip_product(std::span<const StripContact> contacts, const StripLaw& law, Input x, Input dx,
                       Output df);

// (10) Friction is explicit: it changes velocities once before each step, in the order of the contacts. With
// u the part of v_point - sum over j of b_j v_corner_j that is perpendicular to n, and
//
//   W = w_point + sum over j of b_j^2 w_corner_j       w: inverse_mass, n numbers, 1/kg; 0 if pinned
//
// the point gets the impulse J against u, and each corner b_j of the opposite:
//
//   |J| = min(mu p h, |u| / W)
//
// so it never reverses u, and if pinned particles stand still, it never increases the kinetic energy. If W or
// u is 0, there is no impulse. h: the step, s.
void apply_strip_friction(std::span<const StripContact> contacts, const StripLaw& law, Input inverse_mass,
                          double h, Input x, Output v);

}  // namespace hair
