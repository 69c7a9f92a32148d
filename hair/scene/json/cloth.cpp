#include "hair/scene/cloth.h"

#include "hair/scene/json/parts.h"
#include "hair/scene/json/values.h"

namespace hair::json {

namespace {

constexpr long kMostOfARow = 10'000;

void pin(const JsonValue& list, Toy& toy) {
  const int last = toy.columns - 1, below = (toy.rows - 1) * toy.columns;
  const int corners[] = {0, last, below, below + last};
  for (const JsonValue& corner : list.items())
    toy.particles.pinned[corners[corner.word({"top_left", "top_right", "bottom_left", "bottom_right"})]] = 1;
}

}  // namespace

Toy read_cloth(const JsonValue& object, Reading& reading) {
  object.check_keys({"rows", "columns", "corner", "across", "down", "area_density", "stretch"},
                    {"shear", "bend", "damping", "pinned"});
  const long rows = object["rows"].whole_number(2, kMostOfARow);
  const long columns = object["columns"].whole_number(2, kMostOfARow);
  reading.expect(object, rows, columns);
  const Vector3d across = vector(object["across"], kFar), down = vector(object["down"], kFar);
  if (!(across.cross(down).norm() > 1e-6 * across.norm() * down.norm()))
    object["down"].fail("lies along \"across\"; a cloth has an area");
  const double stretch = object["stretch"].number(0, 1e9);
  Toy toy = make_cloth({static_cast<int>(rows), static_cast<int>(columns), vector(object["corner"], kFar),
                        across, down, object["area_density"].number(1e-6, 1e6), stretch,
                        number_or(object, "shear", 0, 0, 1e9), number_or(object, "bend", 0, 0, 1e9),
                        number_or(object, "damping", 0, 0, 1e6)});
  if (!(toy.particles.mass.minCoeff() >= 1e-15))
    object["area_density"].fail("makes particles lighter than 1e-15 kg; give a heavier cloth, or fewer rows");
  if (object.has("pinned")) pin(object["pinned"], toy);
  return toy;
}

}  // namespace hair::json
