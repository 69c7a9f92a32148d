// A strand as a chain of helices, as it lies now. Source: F. Bertails et al., "Super-Helices for Predicting
// the Dynamics of Natural Hair" (SIGGRAPH 2006), section 3.
//
//    root      element 0          element 1                element n-1
//     o--------------------------o---------------------- ... -----------o  tip
//     start   kappa1, kappa2, tau   each element has its own: a piece of a helix (of an arc, of a line)
//
// All vectors are along the axes of the world. Element i has the coordinates q[3i], q[3i + 1], q[3i + 2] =
// kappa1, kappa2, tau. A quantity "for each coordinate" is a matrix of three columns, in this order.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace hair {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// A point of the centre line with its material frame. The columns of `axes` are two directions n1, n2 of the
// cross section and the tangent t. They have length 1 and are perpendicular, with n1 x n2 = t.
struct MaterialFrame {
  Vector3d position = Vector3d::Zero();  // m
  Matrix3d axes = Matrix3d::Identity();
};

// The Jacobian of a point and its frame with respect to the coordinates of their own element, while the
// element's start is held: for a change dq the frame turns by turns * dq (a small rotation is a vector along
// its axis), and the point moves by moves * dq.
struct HelixJacobian {
  Matrix3d turns = Matrix3d::Zero();  // rad m
  Matrix3d moves = Matrix3d::Zero();  // m^2
};

struct HelixElement {
  double length = 0;                      // m, > 0
  Vector3d curvature = Vector3d::Zero();  // kappa1, kappa2, tau, 1/m: the same all along the element
  MaterialFrame start, end;
  HelixJacobian at_end;
};

// A piece of hair: a node of a quadrature, so that integrals along the strand are sums over points. Points
// are in the order of their elements.
struct HelixPoint {
  int element = 0;
  double s = 0;                          // m, from the start of its element
  Vector3d position = Vector3d::Zero();  // m
  Matrix3d moves = Matrix3d::Zero();     // m^2, as in HelixJacobian, for the coordinates of its own element
  Vector3d force =
      Vector3d::Zero();  // N, on this piece: weight, drag, contacts, - mass * acceleration at q" = 0
  Matrix3d inertia =
      Matrix3d::Zero();  // kg: its mass times the identity. Implicit steps add h C for a damping C
                         // and h^2 S for a stiffness S, because these forces grow during the step.
                         // Symmetric, positive semi-definite
};

// The constants of a strand.
struct HelixStrand {
  Eigen::VectorXd lengths;    // m, n elements, > 0
  double line_density = 0;    // rho S, kg/m
  double bend_rigidity = 0;   // EI, N m^2
  double twist_rigidity = 0;  // GJ, N m^2
  Eigen::VectorXd natural;    // 3n, 1/m: the coordinates q^n at which the strand is unstressed

  int elements() const { return static_cast<int>(lengths.size()); }
};

}  // namespace hair
