// What acts on a strand of masses and springs. Each part is a row, with the exercise that it calls: a strand has those
// that it asks for, and a course without the exercise has no such strand.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "hair/mass_spring/moving_strand.h"
#include "hair/mass_spring/strand_forces.h"
#include "hair/mass_spring/strand_start.h"

namespace hair {

// What a strand's forces are made with.
struct ForceOptions {
  GeometricTerm geometric_term = GeometricTerm::filtered;
  Products bend_product = Products::definite;
  Vector3d gravity = Vector3d::Zero();  // m/s^2
  double drag = 0;                      // N s/m^2: for each metre of hair
  Vector3d wind = Vector3d::Zero();     // m/s, of the air that drags
  bool point_forces = false;            // steps come with forces from outside
};

struct ForcePart {
  const char* name;      // "stretching"
  const char* how;       // "springs along the segments"
  const char* exercise;  // "H1"; "": it is given
  bool (*acts)(const StrandStart&);
  // Why no strand of a scene has it.
  const char* (*why_not)(std::span<const StrandStart>);
  // To `sum`, one of the strand's sums, with products as said.
  void (*add)(const StrandStart&, GeometricTerm, Products, MovingStrand&, particles::ForceSum& sum);
};

std::span<const ForcePart> force_parts();

// The exercises that the parts of this strand call.
std::vector<std::string> exercises_of(const StrandStart& start);

// The forces that act, to a strand that was made of `start`. `with_definite`: products of the exact
// derivative, and the same forces with definite products beside them. Throws std::invalid_argument for a part whose
// exercise the course leaves out.
void add_forces(const ForceOptions& options, const StrandStart& start, bool with_definite,
                MovingStrand& moving);

}  // namespace hair
