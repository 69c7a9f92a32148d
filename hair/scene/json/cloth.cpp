#include "hair/scene/cloth.h"

#include "hair/scene/json/keys.h"
#include "hair/scene/json/parts.h"

namespace hair::json {

namespace {

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
  keys.whole({.name = "rows", .needed = true, .least = 2, .most = kMostOfARow, .what = "of particles"},
             cloth.rows);
  keys.whole({.name = "columns", .needed = true, .least = 2, .most = kMostOfARow, .what = "of particles"},
             cloth.columns);
  keys.vector({.name = "corner", .unit = "m", .needed = true, .what = "the top left one"}, cloth.corner);
  keys.vector(
      {.name = "across", .unit = "m", .needed = true, .what = "from there to the top right one: along a row"},
      cloth.across);
  keys.vector({.name = "down", .unit = "m", .needed = true, .what = "from there to the bottom left one"},
              cloth.down);
  keys.number({.name = "area_density", .unit = "kg/m²", .needed = true, .least = 1e-6, .most = 1e6},
              cloth.area_density);
  keys.number({.name = "stretch", .unit = "N/m", .needed = true, .least = 0, .most = kStiffest},
              cloth.stretch);
  keys.number({.name = "shear", .unit = "N/m", .least = 0, .most = kStiffest}, cloth.shear);
  keys.number({.name = "bend", .unit = "N/m", .least = 0, .most = kStiffest}, cloth.bend);
  keys.number({.name = "damping", .unit = "N s/m", .least = 0, .most = 1e6, .what = "of every spring"},
              cloth.damping);
  keys.any({.name = "pinned",
            .otherwise = "none",
            .what = "a list of corners: top_left, top_right, bottom_left, bottom_right"},
           text.pinned);
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
