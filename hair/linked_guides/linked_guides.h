// Guides of masses and springs that a control mesh makes one system, and its steps by implicit Euler (H4).
//
// In each step, frames of particles and contacts are those of its start (H9). Friction changes velocities;
// then one implicit solve moves all particles, with links and strips in its matrix, preconditioned by the
// strands' own bands; then each strand collides; then links remember their stretches, and broken links are
// recorded.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hair/linked_guides/control_mesh.h"
#include "hair/linked_guides/joint_step.h"
#include "hair/mass_spring/mass_spring_body.h"
#include "hair/mass_spring/step_methods.h"

namespace hair {

// The method of each of these strands. Links carry energy from strand to strand, so the strands have a common
// energy balance (linked_energy.h).
extern const StepMethod kLinkedImplicitEuler;

// Throws std::invalid_argument for a mesh with indices or numbers out of bounds, and for guides that are not
// clamped: their roots have no frame. Keeps references to the strands. watched: the record also has the
// energy that wearing links lose.
std::unique_ptr<JointStep> linked_guides(std::vector<MassSpringBody*> strands, const ControlMesh& mesh,
                                         bool watched);

}  // namespace hair
