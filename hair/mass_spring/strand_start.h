// A strand of masses and springs, and its initial state.
#pragma once

#include "hair/mass_spring/rest_curvature.h"
#include "hair/strand.h"
#include "hair/strand/strand_spec.h"
#include "particles/state.h"

namespace hair {

struct StrandStart {
  Strand strand;
  particles::State state;  // 3n each; the root keeps its velocity

  // For a strand that is not straight at rest: two components for each segment (bend_components), and the
  // normal at the root that they refer to. The strand must be clamped, and bends by its rest curvature
  // instead of H2's springs. No effect if EI = 0, because a strand without bending stiffness has no shape to
  // return to.
  Eigen::VectorXd rest_curvature = {};
  Vector3d root_normal = Vector3d::UnitX();
};

// A clamped strand with this rest shape, which starts in that shape.
StrandStart start_at_rest(const Material& material, const RestShape& shape);

// The same for a fibre. Straight hair, and hair that is not clamped, bends by H2's springs.
StrandStart start_at_rest(const Fibre& fibre, const RestShape& shape, bool straight, bool clamped);

// Moves a strand's particles to the positions of `held`.
void hold(const Held& held, StrandStart& start);

// The strand with as many segments as the specification has elements. Throws std::invalid_argument for a
// shape that these segments can't follow, and for values out of bounds.
StrandStart discretise(const StrandSpec& spec);

// Throws std::invalid_argument for values that are out of bounds, not finite or of the wrong size. `name`:
// "strand 3".
void check_start(const std::string& name, const StrandStart& start);

}  // namespace hair
