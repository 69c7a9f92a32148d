// A patch of cloth, made of the same particles and springs as hair: the lecture's closing question.
#pragma once

#include "particles/toys/toy.h"

namespace hair {

// A flat grid of rows x columns particles at equal distances, >= 2 each, between three corners:
//
//   corner ---- across ---- corner + across
//      |
//     down                                       particle (row, column) is number row * columns + column
//      |
//   corner + down
//
// Springs of the given stiffness: along the threads between neighbours (stretch), across the squares (shear),
// and from each particle to the second next along both threads (bend).
struct Cloth {
  int rows, columns;
  Eigen::Vector3d corner, across, down;  // m
  double area_density;          // kg/m^2; inner particles have the mass of a square, those on edges half
  double stretch, shear, bend;  // N/m, >= 0; 0: no such springs
  double damping;               // N s/m, of every spring
};

// Throws std::invalid_argument for fewer than two rows or columns.
particles::Toy make_cloth(const Cloth& cloth);

}  // namespace hair
