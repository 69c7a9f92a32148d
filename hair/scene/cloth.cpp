#include "hair/scene/cloth.h"

#include "particles/require.h"

namespace hair {

namespace {

using Eigen::Vector3d;

// Adds springs from every particle to the one that is this many rows and columns further on.
void add_springs(const Cloth& cloth, int by_rows, int by_columns, double stiffness, particles::Toy& toy) {
  if (stiffness == 0) return;
  for (int r = 0; r + by_rows < cloth.rows; ++r)
    for (int c = 0; c < cloth.columns; ++c) {
      const int to = c + by_columns;
      if (to < 0 || to >= cloth.columns) continue;
      const int i = r * cloth.columns + c, j = (r + by_rows) * cloth.columns + to;
      const double length = (toy.start.x.segment<3>(3 * i) - toy.start.x.segment<3>(3 * j)).norm();
      toy.springs.push_back({i, j, stiffness, length, cloth.damping});
    }
}

}  // namespace

particles::Toy make_cloth(const Cloth& cloth) {
  particles::require_at_least("a cloth's rows", cloth.rows, 2);
  particles::require_at_least("a cloth's columns", cloth.columns, 2);
  const Vector3d right = cloth.across / (cloth.columns - 1), below = cloth.down / (cloth.rows - 1);
  const double square = cloth.area_density * right.cross(below).norm();

  particles::Toy toy;
  toy.rows = cloth.rows;
  toy.columns = cloth.columns;
  const int n = cloth.rows * cloth.columns;
  toy.particles.mass.resize(n);
  toy.particles.pinned.assign(static_cast<std::size_t>(n), 0);
  toy.start = {Eigen::VectorXd(3 * n), Eigen::VectorXd::Zero(3 * n)};
  for (int r = 0; r < cloth.rows; ++r)
    for (int c = 0; c < cloth.columns; ++c) {
      const int i = r * cloth.columns + c;
      const bool top = r == 0 || r == cloth.rows - 1, side = c == 0 || c == cloth.columns - 1;
      toy.particles.mass[i] = square * (top ? 0.5 : 1) * (side ? 0.5 : 1);
      toy.start.x.segment<3>(3 * i) = cloth.corner + c * right + r * below;
    }
  add_springs(cloth, 0, 1, cloth.stretch, toy);
  add_springs(cloth, 1, 0, cloth.stretch, toy);
  add_springs(cloth, 1, 1, cloth.shear, toy);
  add_springs(cloth, 1, -1, cloth.shear, toy);
  add_springs(cloth, 0, 2, cloth.bend, toy);
  add_springs(cloth, 2, 0, cloth.bend, toy);
  return toy;
}

}  // namespace hair
