#include "hair/scene/json/keys.h"
#include "hair/scene/json/parts.h"

namespace hair::json {

namespace {

// Adds springs from every particle to the one that is this many rows and columns further on.
void add_springs(const Cloth& cloth, int by_rows, int by_columns, double stiffness, Toy& toy) {
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

Toy make_cloth(const Cloth& cloth) {
  const Vector3d right = cloth.across / (cloth.columns - 1), below = cloth.down / (cloth.rows - 1);
  const double square = cloth.area_density * right.cross(below).norm();

  Toy toy;
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

void pin(const JsonValue& list, Toy& toy) {
  const int last = toy.columns - 1, below = (toy.rows - 1) * toy.columns;
  const int corners[] = {0, last, below, below + last};
  for (const JsonValue& corner : list.items())
    toy.particles.pinned[corners[corner.word({"top_left", "top_right", "bottom_left", "bottom_right"})]] = 1;
}

}  // namespace

void keys_of(Keys& keys, ClothText& text) {
  keys.about(
      "A grid of particles, flat at the start, with the springs of hair: along the threads (`stretch`), "
      "across the squares (`shear`), and to the next but one (`bend`).");
  Cloth& cloth = text.cloth;
  constexpr double kMostOfARow = 10'000, kStiffest = 1e9;
  keys.whole("rows", cloth.rows, {.needed = true, .least = 2, .most = kMostOfARow}, "of particles");
  keys.whole("columns", cloth.columns, {.needed = true, .least = 2, .most = kMostOfARow}, "of particles");
  keys.vector("corner", cloth.corner, {.unit = "m", .needed = true}, "the top left one");
  keys.vector("across", cloth.across, {.unit = "m", .needed = true},
              "from there to the top right one: along a row");
  keys.vector("down", cloth.down, {.unit = "m", .needed = true}, "from there to the bottom left one");
  keys.number("area_density", cloth.area_density,
              {.unit = "kg/m²", .needed = true, .least = 1e-6, .most = 1e6});
  keys.number("stretch", cloth.stretch, {.unit = "N/m", .needed = true, .least = 0, .most = kStiffest});
  keys.number("shear", cloth.shear, {.unit = "N/m", .least = 0, .most = kStiffest});
  keys.number("bend", cloth.bend, {.unit = "N/m", .least = 0, .most = kStiffest});
  keys.number("damping", cloth.damping, {.unit = "N s/m", .least = 0, .most = 1e6}, "of every spring");
  keys.any("pinned", text.pinned, {.otherwise = "none"},
           "a list of corners: top_left, top_right, bottom_left, bottom_right");
}

Toy read_cloth(const JsonValue& object, Reading& reading) {
  const ClothText text = read<ClothText>(object);
  const Cloth& cloth = text.cloth;
  reading.expect(object, cloth.rows, cloth.columns);
  if (!(cloth.across.cross(cloth.down).norm() > 1e-6 * cloth.across.norm() * cloth.down.norm()))
    object["down"].fail("lies along \"across\"; a cloth has an area");
  Toy toy = make_cloth(cloth);
  if (!(toy.particles.mass.minCoeff() >= 1e-15))
    object["area_density"].fail("makes particles lighter than 1e-15 kg; give a heavier cloth, or fewer rows");
  if (text.pinned) pin(*text.pinned, toy);
  return toy;
}

}  // namespace hair::json
