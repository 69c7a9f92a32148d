// A strand of masses and springs, and where it starts.
#pragma once

#include "hair/mass_spring/rest_curvature.h"
#include "hair/strand.h"
#include "hair/strand/strand_spec.h"
#include "particles/state.h"

namespace hair {

struct StrandStart {
  Strand strand;
  particles::State state;  // 3n each; the root goes on with the velocity that it has

  // Of a strand that is not straight at rest: two components for each segment (bend_components), and the normal
  // at the root that they count from. It must be clamped, and bends by its rest curvature instead of H2's springs.
  // Without effect if EI = 0: what resists no bend has no shape to go back to.
  Eigen::VectorXd rest_curvature = {};
  Vector3d root_normal = Vector3d::UnitX();
};

// A clamped strand that rests in the given shape, and starts there.
StrandStart start_at_rest(const Material& material, const RestShape& shape);

// The same of a fibre. Straight hair, and hair that is not clamped, bends by H2's springs.
StrandStart start_at_rest(const Fibre& fibre, const RestShape& shape, bool straight, bool clamped);

// Moves a strand's particles to where they are held.
void hold(const Held& held, StrandStart& start);

// The strand in as many segments as the specification has elements. Throws std::invalid_argument for a shape that its
// segments can't follow, and what is out of bounds.
StrandStart discretise(const StrandSpec& spec);

// Throws std::invalid_argument for what is out of bounds, not finite or of the wrong size. `name`: "strand 3".
void check_start(const std::string& name, const StrandStart& start);

}  // namespace hair
