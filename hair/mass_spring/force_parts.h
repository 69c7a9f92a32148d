// The forces of a strand of masses and springs. Each part is a row with the exercise that it calls. A strand
// uses the parts that it needs. In a course without a part's exercise, no strand can use that part.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "hair/mass_spring/moving_strand.h"
#include "hair/mass_spring/strand_forces.h"
#include "hair/mass_spring/strand_start.h"

namespace hair {

// Parameters of a strand's forces.
struct ForceOptions {
  GeometricTerm geometric_term = GeometricTerm::filtered;
  Products bend_product = Products::definite;
  Vector3d gravity = Vector3d::Zero();  // m/s^2
  double drag = 0;                      // N s/m^2, per metre of hair
  Vector3d wind = Vector3d::Zero();     // m/s, of the air
  bool point_forces = false;            // steps also apply external forces
  bool band = true;                     // the forces give their band to preconditioners
};

struct ForcePart {
  const char* name;      // "stretching"
  const char* how;       // "springs along the segments"
  const char* exercise;  // "H1"; "" if it needs no exercise
  bool (*acts)(const StrandStart&);
  // The reason why no strand of a scene uses this part.
  const char* (*why_not)(std::span<const StrandStart>);
  // Adds the part to the strand's force, with the given kind of products.
  void (*add)(const StrandStart&, GeometricTerm, Products, MovingStrand&);
  bool of_lengths = false;  // its energy is the stretching of segments
};

std::span<const ForcePart> force_parts();

// The exercises that the parts of this strand call.
std::vector<std::string> exercises_of(const StrandStart& start);

// Adds the forces to a strand that was made from `start`.
void add_forces(const ForceOptions& options, const StrandStart& start, MovingStrand& moving);

}  // namespace hair
